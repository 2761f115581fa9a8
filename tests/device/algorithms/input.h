// The input of an algorithm in one of the forms of property.h, and its output among elements that must not change.
#pragma once

#include "property.h"

namespace property {

/// The part of a structure that an algorithm works on.
struct Placed {
    Taken taken = Taken::whole;
    std::uint32_t extent = 0, first = 0, capacity = 0,
                  count = 0;  ///< the structure has extent elements; the part is capacity elements from first on, of
                              ///< which the algorithm takes the first count

    Placed(Round& round, std::uint32_t size) : taken(round.taken()), count(size) {
        const bool whole = taken == Taken::whole;
        first = whole ? 0 : round.below(70);
        capacity = size + (taken == Taken::counted ? round.below(round.chance(2) ? 6000 : 3) : 0);
        extent = first + capacity + (whole ? 0 : round.below(70));
        // These tests make no structures without elements, so an empty range is never a whole structure.
        if (extent == 0) taken = Taken::part, extent = 1;
        round.has_size(size);
        if (taken != Taken::whole)
            round.about("from " + std::to_string(first) + " of " + std::to_string(extent) + ", place for " +
                        std::to_string(capacity));
    }

    /// `others`, the elements of a structure, with those of the part replaced by `values`.
    template <class T> std::vector<T> among(std::vector<T> others, const std::vector<T>& values) const {
        std::copy(values.begin(), values.end(), others.begin() + first);
        return others;
    }
    /// The part as struct `Part` of forms.glift.
    template <class Part> Part part() const {
        return {.taken = static_cast<glift::uint>(taken), .extent = extent, .first = first, .count = capacity};
    }
};

template <class T> constexpr bool is_vector_of_floats = requires(T x) {
    requires std::is_floating_point_v<decltype(x.x)>;
};

/// A random value: floats and their vectors from -1 to 1; integers, vectors of them and structs of arbitrary bits.
template <class T> T arbitrary(Round& round) {
    if constexpr (std::is_floating_point_v<T>) {
        return static_cast<T>(round.real());
    } else if constexpr (std::is_integral_v<T>) {
        return static_cast<T>(round.engine()());
    } else if constexpr (is_vector_of_floats<T>) {
        T x;
        for (std::size_t i = 0; i < sizeof(T) / sizeof(x.x); ++i) x[i] = static_cast<decltype(x.x)>(round.real());
        return x;
    } else {
        T x;
        static_assert(sizeof x % 4 == 0);
        for (std::size_t i = 0; i < sizeof x; i += 4) {
            const auto word = static_cast<std::uint32_t>(round.engine()());
            std::memcpy(reinterpret_cast<char*>(&x) + i, &word, 4);
        }
        return x;
    }
}

/// `mirrored` of forms.glift on the host; tests with structs of their own specialise it.
template <class T> T mirrored(T x) {
    if constexpr (std::is_floating_point_v<T> || is_vector_of_floats<T>) return -x;
    else return static_cast<T>(~x);
}

/// A structure that has `values` in its part, in the form of the round. Pipelines take up to three structures: `dense`,
/// from which they also make the views of the forms strided and mapped, `folded` and `tiled`. Those that the form of
/// the round does not use have one element.
template <class Dense, class Folded, class Tiled, class Line> struct Input {
    using T = typename Dense::Element;

    glift::uint form, step = 1;
    Dense dense;
    Folded folded;
    Tiled tiled;
    Line length;

    Input(const glift::Device& device, Round& round, const Placed& placed, const std::vector<T>& values)
        : form(static_cast<glift::uint>(round.form())), step(round.form() == Form::strided ? 2 + round.below(4) : 1),
          dense(device, used_by_dense(round.form()) ? placed.extent * step : 1),
          folded(device, round.form() == Form::folded ? placed.extent : 1),
          tiled(device, round.form() == Form::tiled ? placed.extent : 1), length(device, 1) {
        std::vector<T> all(placed.extent);
        for (T& x : all) x = arbitrary<T>(round);
        all = placed.among(std::move(all), values);
        switch (round.form()) {
        case Form::dense: dense.write(all); break;
        case Form::folded: folded.write(all); break;
        case Form::tiled: tiled.write(all); break;
        case Form::mapped:
            for (T& x : all) x = mirrored(x);
            dense.write(all);
            break;
        case Form::strided: {
            std::vector<T> spread(all.size() * step);
            for (std::size_t i = 0; i < spread.size(); ++i)
                spread[i] = i % step == 0 ? all[i / step] : arbitrary<T>(round);
            dense.write(spread);
        }
        }
        length.write(std::vector<glift::uint>{placed.count});
    }

private:
    static bool used_by_dense(Form form) { return form != Form::folded && form != Form::tiled; }
};

/// A structure as long as the input, which may be a view; the algorithm writes the same part of it.
template <class S> struct Output {
    using T = typename S::Element;

    S structure;
    std::vector<T> before;

    Output(const glift::Device& device, Round& round, const Placed& placed) : structure(device, placed.extent) {
        before.resize(placed.extent);
        for (T& x : before) x = arbitrary<T>(round);
    }

    /// The contents of the structure after `run`, which starts from the contents `before`.
    template <class Run> std::vector<T> after(Run run) {
        structure.write(before);
        run(structure);
        return structure.read();
    }

    std::vector<T> expected(const Placed& placed, const std::vector<T>& values) const {
        return placed.among(before, values);
    }
};

template <class T> std::vector<T> arbitrary_values(Round& round, std::uint32_t count) {
    std::vector<T> values(count);
    for (T& x : values) x = arbitrary<T>(round);
    return values;
}

/// Values, either arbitrary or from at most 300 different ones, drawn anew for each element or after runs of random
/// lengths.
template <class T> std::vector<T> values_with_repeats(Round& round, std::uint32_t count) {
    const std::uint32_t kinds = round.chance(3) ? 0 : 1 + round.below(round.chance(2) ? 3 : 300);
    const std::uint32_t run = round.chance(3) ? 1 + round.below(500) : 1;
    std::vector<T> values(count);
    T x{};
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i == 0 || run == 1 || round.chance(run)) {
            if (kinds) x = static_cast<T>(round.below(kinds));
            else x = arbitrary<T>(round);
        }
        values[i] = x;
    }
    return values;
}

}  // namespace property
