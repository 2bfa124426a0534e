// Decomposes a transformation into statements of the language.
#pragma once

#include <optional>

#include "parser/scene.h"

namespace snell {

// A rotation: its angle in degrees and its axis.
struct Turn {
    double angle = 0;
    Vec3 axis{0, 0, 1};
};

// The result: Translate, outer rotation, scale, inner rotation, of which the last is applied first. Diagonal matrices
// need no rotations and are decomposed exactly; others within a few rounding errors of the largest element.
struct Decomposed {
    Vec3 translate{0, 0, 0};
    std::optional<Turn> outer;
    Vec3 scale{1, 1, 1};
    std::optional<Turn> inner;
};

// Decomposes `m`, which must be affine and finite, by singular value decomposition with one-sided Jacobi rotations
// (Golub and Van Loan, Matrix Computations, 8.6.3).
Decomposed decompose(const Mat4& m);

}  // namespace snell
