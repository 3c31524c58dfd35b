// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <doctest/doctest.h>

#include "solver/batch/kernels/kernel.hpp"
#include "solver/batch/tables/law_tables.hpp"
#include "solver/contact/law.hpp"
#include "solver/damping/damping.hpp"

using namespace ashimpact;
using namespace ashimpact::batch;

TEST_CASE("the square that a table gives for a place holds it, at the edges of the table as well") {
    RestitutionTable& table =
        restitution_table(Law::of<Dmt>(), Detachment::zero_overlap, DampingLaw::constant);
    const auto check = [&](double x, double y) {
        const RestitutionPiece* piece = table.at(x, y);
        CAPTURE(x);
        CAPTURE(y);
        REQUIRE(piece != nullptr);
        CHECK(x >= piece->lower(0));
        CHECK(x <= piece->upper(0));
        CHECK(y >= piece->lower(1));
        CHECK(y <= piece->upper(1));
        CHECK(piece->state() != PieceState::unknown);
        CHECK(piece->state() != PieceState::divided);
    };
    // The edges first: a place that was entered wrongly is found again by those after it.
    for (const double edge : {1.0, 0.0})
        for (int i = 0; i <= 256; ++i) {
            check(edge, i / 256.0);
            check(i / 256.0, edge);
        }
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < 64; ++j) check((i + 0.4) / 64, (j + 0.6) / 64);
    CHECK(table.at(std::nan(""), 0.5) == nullptr);
}
