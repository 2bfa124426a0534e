// A transformation as the statements of the language can make it.
#pragma once

#include <optional>

#include "parser/scene.h"

namespace snell {

// Angle in degrees and axis of a rotation.
struct Turn {
    double angle = 0;
    Vec3 axis{0, 0, 1};
};

// Translate, then outer rotation, scale, inner rotation (the last acts first). Linear parts that are diagonal
// come without rotations and are exact; others within some units of rounding of the largest element.
struct Decomposed {
    Vec3 translate{0, 0, 0};
    std::optional<Turn> outer;
    Vec3 scale{1, 1, 1};
    std::optional<Turn> inner;
};

// `m` is affine and finite. The singular value decomposition, by one-sided Jacobi rotations (Golub and
// Van Loan, Matrix Computations, 8.6.3).
Decomposed decompose(const Mat4& m);

}  // namespace snell
