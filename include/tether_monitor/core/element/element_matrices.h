#pragma once

#include <Eigen/Core>

#include "tether_monitor/core/element/unit_matrices.h"

namespace tether_monitor::core
{
/// A symmetric 4 x 4 matrix of scalars that multiplies the four 3-vectors of an element.
using ShapeMatrix = Eigen::Matrix4d;

/**
 * Integral of S_i S_j over an element: the consistent mass matrix is m times this matrix.
 *
 * Model: (M7) of doc/model.md; Blintsov & Trunin (2020), eqs 9 and 14. Exact (degree 6 integrated analytically).
 *
 * @param L  unstretched length of the element [m], > 0.
 */
ShapeMatrix massMatrix(double L);

/**
 * Integral of S_i'' S_j'' over an element: the bending force of an element is EI times this matrix, applied to its
 * four vectors.
 *
 * Model: U = 1/2 EI integral |r''|^2 ds, (M6) of doc/model.md. |r''| is the curvature of the stretched line up to
 * terms of the order of the strain; the form is quadratic, so its tangent is constant and positive semidefinite.
 *
 * @param L  unstretched length of the element [m], > 0.
 */
ShapeMatrix bendingMatrix(double L);

}  // namespace tether_monitor::core
