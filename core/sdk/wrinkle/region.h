// Loops and functions in the generated shader. A body is recorded once; it may use values from
// outside.
//
//   auto noise = function("noise(p)", [](vec3 p) { return ...; });  // one function in the shader
//   Float sum = noise(p) + noise(2 * p);                         // called twice
//
//   auto [t, h] = loop(64, std::tuple{t0, h0}, [&](Float t, Float h) {
//       return std::tuple{h > t, t + step, height(t)};  // condition, next state
//   });
//
// Each iteration computes the condition and the next state from the current state. If the condition
// is false, the loop ends and the next state is discarded. The loop also ends after `max`
// iterations. Its value is the last state. A function returns one value or a tuple of values.
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include "wrinkle/math.h"

namespace wrinkle::sdk {

namespace detail {

// Begins a region and ends it, with poison as result if the body throws.
class Recording {
public:
    Recording(uint32_t kind, const char* name, const uint32_t* types, uint32_t count,
              wr_value* params) {
        if (builder) builder->begin_region(builder, kind, name, types, count, params);
    }
    ~Recording() {
        const wr_value poison = WR_POISON;
        if (builder && !done_) builder->end_region(builder, &poison, 1, 0);
    }
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;
    wr_region finish(const wr_value* results, uint32_t count, uint32_t max_iterations) {
        done_ = true;
        return builder ? builder->end_region(builder, results, count, max_iterations) : 0;
    }

private:
    bool done_ = false;
};

template <class T>
inline constexpr bool is_tuple = false;
template <class... T>
inline constexpr bool is_tuple<std::tuple<T...>> = true;

template <class T>
auto as_tuple(T value) {
    if constexpr (is_tuple<T>)
        return value;
    else
        return std::tuple<T>{value};
}

template <class... T>
wr_region end(Recording& recording, const std::tuple<T...>& results, uint32_t max_iterations) {
    return std::apply(
        [&](const T&... value) {
            const wr_value ids[] = {value.id...};
            return recording.finish(ids, sizeof...(T), max_iterations);
        },
        results);
}

template <class... Args>
void run(wr_region region, wr_value* results, uint32_t count, const Args&... args) {
    const wr_value ids[] = {args.id..., WR_POISON};
    if (builder) builder->apply(builder, region, ids, sizeof...(Args), results, count);
}

// Returns the ids of the host as values of the types in Tuple.
template <class Tuple, size_t... I>
Tuple values(const wr_value* ids, std::index_sequence<I...>) {
    return Tuple{std::tuple_element_t<I, Tuple>(Raw{ids[I]})...};
}
template <class Tuple>
Tuple values(const wr_value* ids) {
    return values<Tuple>(ids, std::make_index_sequence<std::tuple_size_v<Tuple>>{});
}

template <class... T>
struct Types;
template <class... T>
struct Types<std::tuple<T...>> {
    static constexpr uint32_t count = sizeof...(T);
    // Hidden, because gcc makes such a symbol unique in the process (STB_GNU_UNIQUE), and a library
    // that defines one is never unloaded.
    [[gnu::visibility("hidden")]] static constexpr uint32_t numbers[count + 1] = {T::type..., 0};
};

// Result and parameter types of a lambda or of a function pointer.
template <class F>
struct Signature : Signature<decltype(&F::operator())> {};
template <class R, class... A>
struct Signature<R (*)(A...)> {
    using Result = std::remove_cvref_t<R>;
    using Arguments = std::tuple<std::remove_cvref_t<A>...>;
};
template <class R, class C, class... A>
struct Signature<R (C::*)(A...) const> : Signature<R (*)(A...)> {};

}  // namespace detail

template <class Result, class Arguments>
class Function;
template <class Result, class... Args>
class Function<Result, std::tuple<Args...>> {
public:
    explicit Function(wr_region region) : region_(region) {}
    Result operator()(Args... args) const {
        using Tuple = decltype(detail::as_tuple(std::declval<Result>()));
        wr_value ids[std::tuple_size_v<Tuple>] = {};
        detail::run(region_, ids, std::tuple_size_v<Tuple>, args...);
        if constexpr (detail::is_tuple<Result>)
            return detail::values<Tuple>(ids);
        else
            return Result(Raw{ids[0]});
    }

private:
    wr_region region_;
};

// `name` is the name in the generated shader, in lower_snake_case, and may name the parameters:
// "noise(point, width)".
template <class Body>
auto function(const char* name, Body body) {
    using Signature = detail::Signature<Body>;
    using Arguments = typename Signature::Arguments;
    using Types = detail::Types<Arguments>;
    wr_value params[Types::count + 1] = {};
    detail::Recording recording(WR_REGION_FUNCTION, name, Types::numbers, Types::count, params);
    const auto results = detail::as_tuple(std::apply(body, detail::values<Arguments>(params)));
    return Function<typename Signature::Result, Arguments>(detail::end(recording, results, 0));
}

// Returns the last state. `max`: greatest number of iterations, up to 65536. `name` may name the
// members of the state: "loop(k, sum)".
template <class... State, class Body>
std::tuple<State...> loop(const char* name, uint32_t max, std::tuple<State...> initial, Body body) {
    using Next = std::tuple<Bool, State...>;
    static_assert(
        std::is_convertible_v<std::invoke_result_t<Body, State...>, Next>,
        "a loop's body takes the state and returns a tuple of Bool (continue) and the next "
        "state");
    const uint32_t types[] = {State::type...};
    wr_value ids[sizeof...(State)] = {};
    detail::Recording recording(WR_REGION_LOOP, name, types, sizeof...(State), ids);
    const Next next = std::apply(body, detail::values<std::tuple<State...>>(ids));
    const wr_region region = detail::end(recording, next, max);
    std::apply([&](const State&... s) { detail::run(region, ids, sizeof...(State), s...); },
               initial);
    return detail::values<std::tuple<State...>>(ids);
}
template <class... State, class Body>
std::tuple<State...> loop(uint32_t max, std::tuple<State...> initial, Body body) {
    return loop("loop", max, initial, body);
}

}  // namespace wrinkle::sdk
