// Whether two trees say the same: by their members, so that a member that is added is compared.
// SPDX-License-Identifier: MIT
#include "grammar/ast/same.hpp"

#include <cstddef>
#include <tuple>
#include <type_traits>

namespace rmpl::grammar {

/// Converts to whatever a member is: so many of them as an aggregate can be made of, so many members it has. Never
/// defined, only asked about, and so in no anonymous namespace.
struct Anything {
  template <class T>
  operator T() const;  // NOLINT: it is meant to convert
};

namespace {

template <class T, class... Given>
constexpr std::size_t arity() {
  if constexpr (requires { T{Given{}..., Anything{}}; }) {
    return arity<T, Given..., Anything>();
  } else {
    return sizeof...(Given);
  }
}

/// The members of an aggregate, by reference.
template <class T>
auto members(const T& value) {
  constexpr std::size_t count = arity<T>();
  static_assert(count <= 7, "a tree node of more members wants a line here");
  if constexpr (count == 0) {
    return std::tuple();
  } else if constexpr (count == 1) {
    const auto& [a] = value;
    return std::tie(a);
  } else if constexpr (count == 2) {
    const auto& [a, b] = value;
    return std::tie(a, b);
  } else if constexpr (count == 3) {
    const auto& [a, b, c] = value;
    return std::tie(a, b, c);
  } else if constexpr (count == 4) {
    const auto& [a, b, c, d] = value;
    return std::tie(a, b, c, d);
  } else if constexpr (count == 5) {
    const auto& [a, b, c, d, e] = value;
    return std::tie(a, b, c, d, e);
  } else if constexpr (count == 6) {
    const auto& [a, b, c, d, e, f] = value;
    return std::tie(a, b, c, d, e, f);
  } else {
    const auto& [a, b, c, d, e, f, g] = value;
    return std::tie(a, b, c, d, e, f, g);
  }
}

struct Same {
  bool operator()(Span, Span) const { return true; }

  template <class T>
  bool operator()(const std::vector<T>& one, const std::vector<T>& other) const {
    if (one.size() != other.size()) return false;
    for (std::size_t i = 0; i < one.size(); ++i) {
      if (!(*this)(one[i], other[i])) return false;
    }
    return true;
  }

  template <class T>
  bool operator()(const std::optional<T>& one, const std::optional<T>& other) const {
    return one.has_value() == other.has_value() && (!one || (*this)(*one, *other));
  }

  template <class T>
  bool operator()(const Box<T>& one, const Box<T>& other) const {
    return (*this)(*one, *other);
  }

  template <class... T>
  bool operator()(const std::variant<T...>& one, const std::variant<T...>& other) const {
    if (one.index() != other.index()) return false;
    return std::visit([&](const auto& node) { return (*this)(node, std::get<std::decay_t<decltype(node)>>(other)); },
                      one);
  }

  template <class T>
  bool operator()(const T& one, const T& other) const {
    if constexpr (requires { one == other; }) {
      return one == other;
    } else {
      return all(members(one), members(other), std::make_index_sequence<arity<T>()>());
    }
  }

 private:
  template <class Tuple, std::size_t... Member>
  bool all(const Tuple& one, const Tuple& other, std::index_sequence<Member...>) const {
    return ((*this)(std::get<Member>(one), std::get<Member>(other)) && ...);
  }
};

}  // namespace

bool same(const ProgramFile& one, const ProgramFile& other) { return Same{}(one, other); }
bool same(const PlantFile& one, const PlantFile& other) { return Same{}(one, other); }
bool same(const ScenarioFile& one, const ScenarioFile& other) { return Same{}(one, other); }
bool same(const PropertyFile& one, const PropertyFile& other) { return Same{}(one, other); }
bool same(const MonitorFile& one, const MonitorFile& other) { return Same{}(one, other); }

}  // namespace rmpl::grammar
