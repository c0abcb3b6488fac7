// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// Numbers of 32 digits as sums of two doubles, [high, low] (T. J. Dekker, "A floating-point technique for extending the available
/// precision", Numerische Mathematik 18, 1971).

export const exact = value => [value, 0];
export const ZERO = exact(0);
export const NO_VECTOR = [ZERO, ZERO, ZERO];

/// `quick`: |a| >= |b|.
function quickSum(a, b) {
    const sum = a + b;
    return [sum, b - (sum - a)];
}

function wholeSum(a, b) {
    const sum = a + b, part = sum - a;
    return [sum, (a - (sum - part)) + (b - part)];
}

/// Two parts of 26 bits.
function halves(a) {
    const scaled = 134217729 * a, high = scaled - (scaled - a);
    return [high, a - high];
}

function wholeProduct(a, b) {
    const product = a * b, [ah, al] = halves(a), [bh, bl] = halves(b);
    return [product, ((ah * bh - product) + ah * bl + al * bh) + al * bl];
}

export function plus(a, b) {
    const [high, rest] = wholeSum(a[0], b[0]), [low, least] = wholeSum(a[1], b[1]);
    const [sum, more] = quickSum(high, rest + low);
    return quickSum(sum, more + least);
}

export const negative = a => [-a[0], -a[1]];
export const minus = (a, b) => plus(a, negative(b));

export function product(a, b) {
    const [high, low] = wholeProduct(a[0], b[0]);
    return quickSum(high, low + (a[0] * b[1] + a[1] * b[0]));
}

export function quotient(a, b) {
    let rest = a, found = ZERO;
    for (let digits = 0; digits < 3; digits++) {
        const part = exact(rest[0] / b[0]);
        found = plus(found, part);
        rest = minus(rest, product(part, b));
    }
    return found;
}

export const isLess = (a, b) => minus(a, b)[0] < 0;
export const magnitude = a => (a[0] < 0 ? negative(a) : a);

export const exactVector = v => v.map(exact);
export const rounded = v => v.map(x => x[0]);
export const scaled = (s, v) => v.map(x => product(s, x));
export const sumOf = (a, b) => a.map((x, i) => plus(x, b[i]));
export const differenceOf = (a, b) => a.map((x, i) => minus(x, b[i]));
export const scalar = (a, b) => plus(plus(product(a[0], b[0]), product(a[1], b[1])), product(a[2], b[2]));
export const size = v => Math.hypot(...rounded(v));

export function acrossBoth(a, b) {
    const part = (i, j) => minus(product(a[i], b[j]), product(a[j], b[i]));
    return [part(1, 2), part(2, 0), part(0, 1)];
}
