// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// The plane k.X = 1 of least greatest blur: the strict Chebyshev solution of k.D = 1/z by exchanging circuits, as in
/// povray-src/tilt_lens/camera/sharp_plane.h.

import {
    NO_VECTOR, ZERO, acrossBoth, differenceOf, exact, exactVector, isLess, magnitude, minus, negative, plus, product, quotient,
    rounded, scalar, scaled, size, sumOf,
} from "./exact.js";

/// Relative to a length: smaller remainders are dependent.
const DEPENDENT = 1e-12;
/// Relative to the greatest vergence: smaller differences of deviations count as none.
const SAME = 1e-24;

const isEmpty = row => row.direction === NO_VECTOR;

/// Directions of some rows, and the k that leaves given residuals.
class Span {
    constructor() {
        this.k = NO_VECTOR;
        this.basis = []; // orthogonal
    }

    /// At right angles to the span; NO_VECTOR where only rounding is left.
    beside(row) {
        let { direction } = row;
        for (const one of [...this.basis, ...this.basis]) // the second turn removes the rounding of the first
            direction = differenceOf(direction, scaled(quotient(scalar(direction, one), scalar(one, one)), one));
        return size(direction) > row.rounding ? direction : NO_VECTOR;
    }

    holds(row) {
        return this.beside(row) === NO_VECTOR;
    }

    add(row, residual = ZERO) {
        const one = this.beside(row), left = minus(minus(row.vergence, residual), scalar(this.k, row.direction));
        this.k = sumOf(this.k, scaled(quotient(left, scalar(one, row.direction)), one));
        this.basis.push(one);
    }

    rest(row) {
        return { ...row, direction: this.beside(row), vergence: minus(row.vergence, scalar(this.k, row.direction)) };
    }
}

const NO_CIRCUIT = { rows: [], weights: [], deviation: ZERO };

/// Independent rows whose span holds `last`.
function circuitOf(rows, independent, last) {
    const found = [], weights = [];
    for (const i of independent) {
        const others = new Span();
        for (const other of independent)
            if (other !== i)
                others.add(rows[other]);
        if (others.holds(rows[last]))
            continue;
        const beside = others.beside(rows[i]);
        found.push(i);
        weights.push(quotient(scalar(rows[last].direction, beside), scalar(rows[i].direction, beside)));
    }
    found.push(last);
    weights.push(exact(-1));
    const deviation = weights.reduce((sum, weight, i) => plus(sum, product(weight, rows[found[i]].vergence)), ZERO);
    const scale = quotient(exact(deviation[0] < 0 ? -1 : 1), weights.map(magnitude).reduce(plus));
    return { rows: found, weights: weights.map(weight => product(weight, scale)), deviation: product(deviation, scale) };
}

/// Null if the rows are independent.
function firstCircuit(rows, few) {
    const span = new Span(), independent = [];
    for (const i of few) {
        if (span.holds(rows[i]))
            return circuitOf(rows, independent, i);
        span.add(rows[i]);
        independent.push(i);
    }
    return null;
}

function greatestCircuit(rows, few) {
    let greatest = NO_CIRCUIT;
    for (let chosen = 1; chosen < 1 << few.length; chosen++) {
        const circuit = firstCircuit(rows, few.filter((_, i) => (chosen >> i) & 1));
        if (circuit && (greatest === NO_CIRCUIT || isLess(greatest.deviation, circuit.deviation)))
            greatest = circuit;
    }
    return greatest;
}

function solveBeside(rows, circuit, same) {
    const span = new Span(), { deviation } = circuit;
    circuit.rows.slice(0, -1).forEach((row, i) => span.add(rows[row], circuit.weights[i][0] > 0 ? deviation : negative(deviation)));
    const indices = rows.map((_, i) => i).filter(i => !circuit.rows.includes(i));
    const solved = strictSolution(indices.map(i => span.rest(rows[i])), same);
    return { k: sumOf(span.k, solved.k), circuit: { ...solved.circuit, rows: solved.circuit.rows.map(row => indices[row]) } };
}

/// Until no row has a greater deviation. No row may be empty.
function solveRows(rows, same) {
    let circuit = firstCircuit(rows, rows.map((_, i) => i));
    if (!circuit) {
        const span = new Span();
        rows.forEach(row => span.add(row));
        return { k: span.k, circuit: NO_CIRCUIT };
    }
    for (;;) {
        const beside = solveBeside(rows, circuit, same);
        if (!isLess(plus(circuit.deviation, same), beside.circuit.deviation))
            return { k: beside.k, circuit };
        const greater = greatestCircuit(rows, [...circuit.rows, ...beside.circuit.rows]);
        if (!isLess(circuit.deviation, greater.deviation))
            return { k: beside.k, circuit: beside.circuit };
        circuit = greater;
    }
}

/// Empty rows have a circuit of their own, without effect on k.
function strictSolution(rows, same) {
    const full = rows.map((_, i) => i).filter(i => !isEmpty(rows[i]));
    let empty = NO_CIRCUIT;
    rows.forEach((row, i) => {
        const deviation = magnitude(row.vergence);
        if (isEmpty(row) && (empty === NO_CIRCUIT || isLess(empty.deviation, deviation)))
            empty = { rows: [i], weights: [exact(row.vergence[0] < 0 ? -1 : 1)], deviation };
    });
    const { k, circuit } = solveRows(full.map(i => rows[i]), same);
    const fuller = { ...circuit, rows: circuit.rows.map(row => full[row]) };
    return { k, circuit: isLess(circuit.deviation, empty.deviation) ? empty : fuller };
}

function rowsOf(points, camera, axis) {
    const across = acrossBoth(exactVector(camera.right), exactVector(camera.up)), side = exact(scalar(across, exactVector(axis))[0] < 0 ? -1 : 1);
    return points.map(point => {
        const way = differenceOf(exactVector(point), exactVector(camera.location)), vergence = quotient(side, scalar(way, across));
        const direction = scaled(vergence, way);
        return { direction, vergence, rounding: DEPENDENT * size(direction) };
    });
}

/// Null if the points are on one line of the picture.
/// @param points world, before the lens
export function planeOfLeastBlur(points, camera, axis) {
    const rows = rowsOf(points, camera, axis), span = new Span();
    for (const row of rows)
        if (!span.holds(row))
            span.add(row);
    if (span.basis.length < 3)
        return null;
    return rounded(strictSolution(rows, exact(SAME * Math.max(...rows.map(row => row.vergence[0])))).k);
}
