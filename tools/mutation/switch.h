/// @file switch.h
/// Small changes that are compiled in and switched on one at a time: tools/mutate puts these calls into
/// copies of sources.
///
/// The environment variable SINEW_MUTANT holds the number of the change that is on; without it the program
/// does what the unchanged one does. With SINEW_REACHED, the file it names gets a line for each change that
/// was come by.
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <type_traits>

namespace sinew_mutation {

bool on(int mutant);            ///< whether the change is on; notes that it was come by
void not_possible(int mutant);  ///< notes that there is nothing to change: the types have no such operation

/// A literal, or what it becomes.
template <typename T>
T pick(int mutant, T was, T now) {
    return on(mutant) ? now : was;
}

/// What an expression gives, as a value: expressions of Eigen hold references to what is gone afterwards.
template <typename T>
struct Value {
    using type = std::decay_t<T>;
};
template <typename T>
requires requires { typename std::decay_t<T>::PlainObject; }
struct Value<T> {
    using type = typename std::decay_t<T>::PlainObject;
};

// `a < b` becomes `a < Operator<Less, AtLeast>{mutant} < b`: the same precedence, and the operands need not
// be found.
template <typename Was, typename Now, typename OrNow = Now>
struct Operator {
    int mutant;
    int other = -1;  ///< a second change of the same operator
};
template <typename A, typename Operator>
struct WithLeft {
    A left;
    Operator changes;
};

/// Whether an operator becomes one that only says otherwise of equal numbers, which real numbers hardly ever
/// are.
template <typename Was, typename Now>
inline constexpr bool equal_only = false;

template <typename Was, typename Now, typename Result, typename A, typename B>
void change(int mutant, Result& result, A&& a, B&& b) {
    constexpr bool real =
        std::is_floating_point_v<std::decay_t<A>> || std::is_floating_point_v<std::decay_t<B>>;
    if constexpr (requires { Result(Now{}(a, b)); } && !(real && equal_only<Was, Now>)) {
        if (on(mutant)) result = Now{}(a, b);
    } else {
        not_possible(mutant);
    }
}

template <typename Was, typename Now, typename OrNow, typename A, typename B>
auto apply(Operator<Was, Now, OrNow> changes, A&& a, B&& b) {
    typename Value<decltype(Was{}(a, b))>::type result = Was{}(a, b);
    change<Was, Now>(changes.mutant, result, a, b);
    if (changes.other >= 0) change<Was, OrNow>(changes.other, result, a, b);
    return result;
}

#define SINEW_MUTATION_OPERATOR(name, sign)                                                            \
    struct name {                                                                                      \
        template <typename A, typename B>                                                              \
        auto operator()(A&& a, B&& b) const -> decltype(a sign b) {                                    \
            return a sign b;                                                                           \
        }                                                                                              \
    };                                                                                                 \
    template <typename A, typename Was, typename Now, typename OrNow>                                  \
    WithLeft<A&&, Operator<Was, Now, OrNow>> operator sign(A&& a, Operator<Was, Now, OrNow> changes) { \
        return {static_cast<A&&>(a), changes};                                                         \
    }                                                                                                  \
    template <typename A, typename Changes, typename B>                                                \
    auto operator sign(WithLeft<A, Changes> left, B&& b) {                                             \
        return apply(left.changes, static_cast<A>(left.left), static_cast<B&&>(b));                    \
    }
SINEW_MUTATION_OPERATOR(Less, <)
SINEW_MUTATION_OPERATOR(Greater, >)
SINEW_MUTATION_OPERATOR(AtMost, <=)
SINEW_MUTATION_OPERATOR(AtLeast, >=)
SINEW_MUTATION_OPERATOR(Equal, ==)
SINEW_MUTATION_OPERATOR(Unequal, !=)
SINEW_MUTATION_OPERATOR(Plus, +)
SINEW_MUTATION_OPERATOR(Minus, -)
SINEW_MUTATION_OPERATOR(Times, *)
SINEW_MUTATION_OPERATOR(Over, /)
#undef SINEW_MUTATION_OPERATOR
template <>
inline constexpr bool equal_only<Less, AtMost> = true;
template <>
inline constexpr bool equal_only<AtMost, Less> = true;
template <>
inline constexpr bool equal_only<Greater, AtLeast> = true;
template <>
inline constexpr bool equal_only<AtLeast, Greater> = true;

/// `-a` becomes `Negative{mutant} * a`.
struct Negative {
    int mutant;
};
template <typename A>
auto operator*(Negative negative, A&& a) {
    using Result = typename Value<decltype(-a)>::type;
    return on(negative.mutant) ? Result(a) : Result(-a);
}

/// std::min or std::max, and the other of the two.
template <bool smaller>
struct Extreme {
    int mutant;
    template <typename T>
    T operator()(const T& a, const T& b) const {
        return on(mutant) == smaller ? std::max(a, b) : std::min(a, b);
    }
    template <typename T>
    T operator()(std::initializer_list<T> all) const {
        return on(mutant) == smaller ? std::max(all) : std::min(all);
    }
};

}  // namespace sinew_mutation
