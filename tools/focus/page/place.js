// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// World coordinates and those before a camera's transformations. Matrices have four rows, for row vectors.

import { add, dot, length, times } from "./vector.js";

const AS_IT_IS = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];

export const WORLD = { matrix: AS_IT_IS, inverse: AS_IT_IS, scale: 1 };

export const movedDirection = (matrix, v) => [0, 1, 2].map(i => v[0] * matrix[0][i] + v[1] * matrix[1][i] + v[2] * matrix[2][i]);

export const movedPoint = (matrix, p) => add(movedDirection(matrix, p), matrix[3].slice(0, 3));

/// The plane { normal, distance } gets a normal of length 1.
export function planeBefore(matrix, { normal, distance }) {
    const across = matrix.slice(0, 3).map(row => dot(row.slice(0, 3), normal)), size = length(across);
    return { normal: times(1 / size, across), distance: (distance - dot(normal, matrix[3].slice(0, 3))) / size };
}
