// Binds the body of a node to its ports: reads the arguments, checks the signature at compile time,
// and makes the C callback build(). Internal to the SDK.
#pragma once

#include <exception>
#include <tuple>
#include <type_traits>
#include <utility>

#include "wrinkle/port.h"

namespace wrinkle::sdk::detail {

// Ports as types. `port` is the index in the descriptor, `Value` the body's parameter or result.
template <class T, uint32_t port>
struct InputPort {
    using Value = T;
    static Value read() { return Value(Raw{builder->input(builder, port)}); }
};
template <uint32_t port>
struct InputPort<Image, port> {
    using Value = Image;
    static Value read() { return Image(builder->image(builder, port)); }
};
template <uint32_t port>
struct ChoicePort {
    using Value = Choice;
    static Value read() { return {builder->option(builder, port)}; }
};
template <uint32_t port>
struct CountPort {
    using Value = int;
    static Value read() { return builder->option(builder, port); }
};
template <uint32_t port>
struct FlagPort {
    using Value = bool;
    static Value read() { return builder->option(builder, port) != 0; }
};
template <class T, class Domain, uint32_t port>
struct FieldPort {
    using Value = Field<T, Domain>;
    static Value read() { return Value(port); }
};
template <class T, uint32_t port>
struct OutputPort {
    using Value = T;
    static constexpr uint32_t index = port;
};

template <class... P>
struct Ports {
    template <class More>
    using With = Ports<P..., More>;
    static constexpr size_t count = sizeof...(P);
};

struct Anything {
    template <class T>
    operator T() const;
};

// The one parameter of a body that takes a struct.
template <class F>
struct Parameter;
template <class R, class C, class A>
struct Parameter<R (C::*)(A) const> {
    using type = std::remove_cvref_t<A>;
};

template <class S, class... V>
concept MadeOf = std::is_aggregate_v<S> && requires {
    S{std::declval<V>()...};
} && !requires {
    S{std::declval<V>()..., Anything{}};
};

template <class F, class... V>
constexpr bool takes_struct() {
    if constexpr (requires { typename Parameter<decltype(&F::operator())>::type; })
        return MadeOf<typename Parameter<decltype(&F::operator())>::type, V...>;
    else
        return false;
}

// The braced lists guarantee that arguments are read in port order. A struct may have an array for
// ports in a row: its inner braces are left out.
#ifdef __clang__
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wmissing-braces"
#endif
template <class F, class... P>
auto call(Ports<P...>) {
    if constexpr (std::is_invocable_v<F, typename P::Value...>) {
        std::tuple<typename P::Value...> arguments{P::read()...};
        return std::apply(F{}, arguments);
    } else {
        return F{}(typename Parameter<decltype(&F::operator())>::type{P::read()...});
    }
}
#ifdef __clang__
#pragma clang diagnostic pop
#endif

template <class F, class... P>
constexpr bool callable(Ports<P...>) {
    return std::is_invocable_v<F, typename P::Value...> || takes_struct<F, typename P::Value...>();
}

// The body with a second overload, for has_own_error(). The overload of OrAnything ranks below a
// body whose parameters match; that of OrTheSame ranks above a body that needs a conversion; that
// of OrOne makes a call of a body with one `auto` parameter ambiguous.
template <class F>
struct OrAnything : F {
    using F::operator();
    void operator()(...) const;
};
template <class F>
struct OrTheSame : F {
    using F::operator();
    template <class... T>
    void operator()(T...) const;
};
template <class F>
struct OrOne : F {
    using F::operator();
    template <class T>
    void operator()(T&&) const;  // T&&, because a T would have the signature of the body
};

template <class F>
constexpr bool is_generic = !requires {
    &F::operator();
};

// Returns true if the parameters match but a statement of the body is invalid. The compiler then
// reports that error, so check_body() adds none.
template <class F, class... P>
constexpr bool has_own_error(Ports<P...>) {
    if constexpr (!std::is_invocable_v<OrAnything<F>, typename P::Value...> ||
                  !std::is_invocable_v<OrTheSame<F>, typename P::Value...>)
        return true;
    else if constexpr (!std::is_invocable_v<OrOne<F>, Anything>)
        return false;
    else
        return !std::is_invocable_v<OrAnything<F>, Anything>;
}

template <class R, class P>
constexpr bool gives(Ports<P>) {
    return std::is_convertible_v<R, typename P::Value>;
}
template <class R, class... P>
requires(sizeof...(P) != 1) constexpr bool gives(Ports<P...>) {
    return std::is_convertible_v<R, std::tuple<typename P::Value...>>;
}

template <class R, class P>
void write(const R& result, Ports<P>) {
    builder->output(builder, P::index, static_cast<typename P::Value>(result).id);
}
template <class R, class... P>
requires(sizeof...(P) != 1) void write(const R& result, Ports<P...>) {
    const std::tuple<typename P::Value...> values = result;
    std::apply(
        [](const typename P::Value&... value) {
            (builder->output(builder, P::index, value.id), ...);
        },
        values);
}

template <class... P>
void write_poison(Ports<P...>) {
    (builder->output(builder, P::index, WR_POISON), ...);
}

// The build() of a node. An exception becomes a diagnostic, and all outputs become poison.
template <class F, class Inputs, class Outputs>
void build(const wr_builder* b) noexcept {
    const UseBuilder use(b);
    try {
        write(call<F>(Inputs{}), Outputs{});
        return;
    } catch (const std::exception& problem) {
        fail(problem.what());
    } catch (...) {
        fail("the node's body threw something other than a std::exception");
    }
    write_poison(Outputs{});
}

template <class F, class Inputs, class Outputs>
constexpr void check_body() {
    static_assert(Outputs::count > 0, "a node needs an output: declare one with .out<T>()");
    static_assert(std::is_empty_v<F>, "a node has no state: its body must not capture anything");
    constexpr bool fits = callable<F>(Inputs{}) || has_own_error<F>(Inputs{});
    static_assert(
        fits || is_generic<F>,
        "the body's parameters must match the declared inputs, choices, counts, flags and "
        "fields in their order; or it takes one struct with these members in this order");
    static_assert(fits || !is_generic<F>,
                  "the body cannot be called: an error in it is shown above, or else it must have "
                  "as many parameters as there are inputs, choices, counts, flags and fields");
    if constexpr (callable<F>(Inputs{})) {
        static_assert(gives<decltype(call<F>(Inputs{}))>(Outputs{}),
                      "the body must return the declared output, or a std::tuple of the outputs in "
                      "their order");
    }
}

}  // namespace wrinkle::sdk::detail
