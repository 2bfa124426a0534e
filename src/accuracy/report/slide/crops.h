// Where pictures differ most, and what of them is shown there.
#pragma once

#include <span>
#include <vector>

#include "src/accuracy/report/slide/slide.h"

namespace snell::accuracy {

// For each pixel, by how much the display values of the pictures differ from each other; of a single picture, from the
// reference. All have the same size. Between 0 and 1.
std::vector<float> disagreement(std::span<const Picture* const> pictures, const Picture& reference);

// The window of this size, or of the picture's if that is smaller, in which the sum of the values is largest; of equal
// ones the first by rows. There are width × height values.
Window largest_window(const std::vector<float>& values, int width, int height, int window_width, int window_height);

// The window's pixels as they are shown.
content::Image crop(const Picture& picture, const Window& window);
// FLIP in the window, as flip_map computes it for the whole pictures.
std::vector<float> flip_in(const Picture& picture, const Picture& reference, const Window& window);
// In the colours of content::heat.
content::Image colored(std::span<const float> values, const Window& window, double scale);

}  // namespace snell::accuracy
