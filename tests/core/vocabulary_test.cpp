// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/vocabulary.hpp"

#include <stdexcept>

#include <doctest/doctest.h>

#include "core/quantities/quantity.hpp"
#include "materials/xrd/table_layout.hpp"

namespace ashimpact::test {

TEST_CASE("every list of columns and rows of XRD tables has a meaning") {
    const WordLists columns("XRD columns");
    for (const auto& [word, list] : columns.words()) {
        CAPTURE(list);
        CHECK(named<xrd::Role>(list) != xrd::Role::other);
    }
    const WordLists rows("XRD rows");
    for (const auto& [word, list] : rows.words()) {
        CAPTURE(list);
        CHECK(named<xrd::RowMeaning>(list) != xrd::RowMeaning::phase);
    }
    CHECK_THROWS_AS(WordLists("no such group"), std::exception);
}

TEST_CASE("headings are found however umlauts and accents are spelled") {
    for (const char* heading : {"Échantillon", "echantillon", "e\u0301chantillon", "ÉCHANTILLON"})
        CHECK(xrd::read_heading(heading).role == xrd::Role::sample);
    for (const char* heading : {"Incertitude élargie", "incertitude elargie", "±", "+/-", "σ", "±σ", "s.u."})
        CHECK(is_uncertainty_word(heading));
    CHECK_FALSE(is_uncertainty_word("quartz"));
    CHECK(xrd::read_heading("%").role == xrd::Role::weight);
    CHECK(xrd::read_heading("+").role == xrd::Role::uncertainty);
    CHECK(xrd::read_heading("Dichte").role == xrd::Role::other);
    CHECK(xrd::read_heading("Density (g/cm³)").unit == "g/cm³");
    CHECK(xrd::meaning_of_row("Σ") == xrd::RowMeaning::total);
    CHECK(xrd::meaning_of_row("Total crystalline [%]") == xrd::RowMeaning::crystalline_total);
    CHECK(xrd::meaning_of_row("sigma") == xrd::RowMeaning::phase);
    CHECK(says_no_number("N.D."));
    CHECK_FALSE(says_no_number("1"));
}

}  // namespace ashimpact::test
