// The algorithms of std::ranges that the sources use, with the same arguments and projections: not every standard
// library that builds snell has them yet (libc++ only since version 15).
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>

namespace snell::ranges {

template <class Range, class Wanted, class Projection = std::identity>
constexpr auto find_if(Range&& range, Wanted wanted, Projection projection = {}) {
    auto at = std::begin(range);
    for (const auto end = std::end(range); at != end; ++at)
        if (std::invoke(wanted, std::invoke(projection, *at))) break;
    return at;
}

template <class Range, class Value, class Projection = std::identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
    return ranges::find_if(
        range, [&](const auto& one) { return one == value; }, std::move(projection));
}

template <class Range, class Wanted, class Projection = std::identity>
constexpr bool any_of(Range&& range, Wanted wanted, Projection projection = {}) {
    return ranges::find_if(range, std::move(wanted), std::move(projection)) != std::end(range);
}

template <class Range, class Wanted, class Projection = std::identity>
constexpr bool none_of(Range&& range, Wanted wanted, Projection projection = {}) {
    return !ranges::any_of(range, std::move(wanted), std::move(projection));
}

template <class Range, class Wanted, class Projection = std::identity>
constexpr bool all_of(Range&& range, Wanted wanted, Projection projection = {}) {
    return ranges::none_of(range, std::not_fn(std::move(wanted)), std::move(projection));
}

template <class Range, class Wanted, class Projection = std::identity>
constexpr std::ptrdiff_t count_if(Range&& range, Wanted wanted, Projection projection = {}) {
    std::ptrdiff_t count = 0;
    for (auto&& one : range)
        if (std::invoke(wanted, std::invoke(projection, one))) ++count;
    return count;
}

template <class Range, class Value, class Projection = std::identity>
constexpr std::ptrdiff_t count(Range&& range, const Value& value, Projection projection = {}) {
    return ranges::count_if(
        range, [&](const auto& one) { return one == value; }, std::move(projection));
}

template <class A, class B, class Same = std::equal_to<>, class OfA = std::identity, class OfB = std::identity>
constexpr bool equal(A&& a, B&& b, Same same = {}, OfA of_a = {}, OfB of_b = {}) {
    return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b), [&](const auto& x, const auto& y) {
        return std::invoke(same, std::invoke(of_a, x), std::invoke(of_b, y));
    });
}

template <class Range, class Action>
constexpr void for_each(Range&& range, Action action) {
    for (auto&& one : range) std::invoke(action, one);
}

template <class Range, class Out, class Change>
constexpr Out transform(Range&& range, Out out, Change change) {
    for (auto&& one : range) *out++ = std::invoke(change, one);
    return out;
}

template <class Range, class Out>
constexpr Out copy(Range&& range, Out out) {
    return std::copy(std::begin(range), std::end(range), out);
}

template <class Range, class Out, class Wanted>
constexpr Out copy_if(Range&& range, Out out, Wanted wanted) {
    return std::copy_if(std::begin(range), std::end(range), out, std::move(wanted));
}

// The comparison of projections.
template <class Less, class Projection>
constexpr auto by(Less& less, Projection& projection) {
    return [&](const auto& a, const auto& b) {
        return static_cast<bool>(std::invoke(less, std::invoke(projection, a), std::invoke(projection, b)));
    };
}

template <class Range, class Less = std::less<>, class Projection = std::identity>
constexpr void sort(Range&& range, Less less = {}, Projection projection = {}) {
    std::sort(std::begin(range), std::end(range), by(less, projection));
}

template <class Range, class Less = std::less<>, class Projection = std::identity>
void stable_sort(Range&& range, Less less = {}, Projection projection = {}) {
    std::stable_sort(std::begin(range), std::end(range), by(less, projection));
}

template <class Range, class Less = std::less<>, class Projection = std::identity>
constexpr auto min_element(Range&& range, Less less = {}, Projection projection = {}) {
    return std::min_element(std::begin(range), std::end(range), by(less, projection));
}

template <class Range, class Less = std::less<>, class Projection = std::identity>
constexpr auto max_element(Range&& range, Less less = {}, Projection projection = {}) {
    return std::max_element(std::begin(range), std::end(range), by(less, projection));
}

// The range must not be empty.
template <class Range, class Less = std::less<>, class Projection = std::identity>
constexpr auto min(Range&& range, Less less = {}, Projection projection = {}) {
    return *ranges::min_element(range, std::move(less), std::move(projection));
}

template <class Range, class Less = std::less<>, class Projection = std::identity>
constexpr auto max(Range&& range, Less less = {}, Projection projection = {}) {
    return *ranges::max_element(range, std::move(less), std::move(projection));
}

}  // namespace snell::ranges
