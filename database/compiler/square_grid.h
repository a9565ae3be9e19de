#pragma once
/// Squares over a grid of vertices: churned water, patchworks, wake fields.

#include "database/compiler/model_object.h"

#include <cstdint>
#include <utility>

namespace linkdig::database {

/// Adds columns x rows squares, row by row, over the object's first (columns + 1) x (rows + 1) vertices, counter-clockwise;
/// `dress(face, number)` gives each its style.
template <typename Dress>
void add_squares(std::uint32_t columns, std::uint32_t rows, ModelObject& object, Dress dress) {
    const std::uint32_t stride = columns + 1;
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t corner = row * stride + column;
            ModelFace face;
            face.corners = {corner, corner + 1, corner + stride + 1, corner + stride};
            face.at = object.at;
            dress(face, row * columns + column);
            object.faces.push_back(std::move(face));
        }
    }
}

} // namespace linkdig::database
