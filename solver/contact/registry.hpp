#pragma once

#include "solver/contact/brach_dunn.hpp"
#include "solver/contact/dmt.hpp"
#include "solver/contact/hertz.hpp"
#include "solver/contact/jkr.hpp"
#include "solver/contact/thornton_ning.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace ashimpact {

/// A list of contact laws; the position in the list is the identity of a law at run time.
template <template <class> class... L>
struct LawList {
    static constexpr std::size_t size = sizeof...(L);
    static constexpr std::array<std::string_view, size> names{L<double>::name...};

    /// Calls @p visitor.template operator()<Law>() for the law at @p index (which must be below size).
    template <class Result, class Visitor>
    static Result visit(std::size_t index, Visitor&& visitor) {
        using Entry = Result (*)(Visitor&);
        static constexpr std::array<Entry, size> entries{&call<L, Result, Visitor>...};
        return entries[index](visitor);
    }

  private:
    template <template <class> class One, class Result, class Visitor>
    static Result call(Visitor& visitor) {
        return visitor.template operator()<One>();
    }
};

/// Every contact law with dynamics. Registering a law is one word here.
using RegisteredLaws = LawList<Hertz, Dmt, BrachDunn, Jkr, ThorntonNing>;

/// A registered contact law, chosen at run time.
class Law {
  public:
    /// @throws InputError naming the registered laws
    [[nodiscard]] static Law named(std::string_view name);
    /// The law of that template, e.g. Law::of<Dmt>().
    template <template <class> class L>
    [[nodiscard]] static constexpr Law of() {
        std::size_t index = 0;
        while (RegisteredLaws::names[index] != L<double>::name) ++index;
        return Law(index);
    }
    /// The law at a position of the registry, for loops over all of them.
    [[nodiscard]] static constexpr Law at(std::size_t index) { return Law(index); }
    [[nodiscard]] static constexpr std::size_t count() { return RegisteredLaws::size; }

    [[nodiscard]] constexpr std::size_t index() const { return index_; }
    [[nodiscard]] std::string_view name() const { return RegisteredLaws::names[index_]; }
    [[nodiscard]] Detachment default_detachment() const;

    /// Calls @p visitor.template operator()<L>() with the law's template.
    template <class Result, class Visitor>
    Result visit(Visitor&& visitor) const {
        return RegisteredLaws::visit<Result>(index_, visitor);
    }

    friend constexpr bool operator==(const Law&, const Law&) = default;

  private:
    explicit constexpr Law(std::size_t index) : index_(index) {}
    std::size_t index_;
};

/// "hertz, dmt, ...", for messages.
[[nodiscard]] std::string law_names();

}  // namespace ashimpact
