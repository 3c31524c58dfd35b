// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>

namespace ashimpact::batch {

enum class PieceState : std::uint8_t {
    unknown,    ///< not yet computed
    tabulated,  ///< the content gives the results
    captured,   ///< everything on the piece is captured
    divided,
    undecided,  ///< at the edge of capture, which cuts even the smallest pieces: integrate
};

/// An interval (one dimension) or a square (two) of a table. Its state is computed once, when it is first
/// needed; from then on the piece is immutable. Thread-safe.
template <std::size_t dimensions, class Contents>
class Piece {
  public:
    using Content = Contents;
    using Place = std::array<double, dimensions>;
    static constexpr std::size_t axes = dimensions;

    /// Before the piece is computed.
    void span(const Place& middle, double half_width) {
        middle_ = middle;
        stretch_ = 1.0 / half_width;
    }
    [[nodiscard]] double lower(std::size_t axis) const { return middle_[axis] - 1.0 / stretch_; }
    [[nodiscard]] double upper(std::size_t axis) const { return middle_[axis] + 1.0 / stretch_; }
    /// From -1 to 1 over the piece.
    [[nodiscard]] double local(std::size_t axis, double x) const { return (x - middle_[axis]) * stretch_; }

    [[nodiscard]] PieceState state() const { return state_.load(std::memory_order_acquire); }
    /// Only in state tabulated.
    [[nodiscard]] const Content& content() const { return content_; }
    /// The part that contains a place; only in state divided.
    [[nodiscard]] Piece& part(const Place& place) const {
        std::size_t k = 0;
        for (std::size_t axis = 0; axis < dimensions; ++axis)
            k += place[axis] >= middle_[axis] ? std::size_t{1} << axis : 0U;
        return (*parts_)[k];
    }

    /// Computes the state; other threads wait for the first.
    /// @param judge called with the content to fill; returns the state, unknown if the piece has to be
    /// divided
    /// @param last the piece is too small to be divided
    template <class Judge>
    void compute(bool last, const Judge& judge) {
        std::call_once(computed_, [&] {
            PieceState state = judge(content_);
            if (state == PieceState::unknown) state = last ? PieceState::undecided : PieceState::divided;
            if (state == PieceState::divided) divide();
            state_.store(state, std::memory_order_release);
        });
    }

  private:
    void divide() {
        parts_ = std::make_unique<std::array<Piece, std::size_t{1} << dimensions>>();
        for (std::size_t k = 0; k < parts_->size(); ++k) {
            Place middle = middle_;
            for (std::size_t axis = 0; axis < dimensions; ++axis)
                middle[axis] += ((k >> axis) % 2 == 0 ? -0.5 : 0.5) / stretch_;
            (*parts_)[k].span(middle, 0.5 / stretch_);
        }
    }

    Place middle_{};
    double stretch_ = 1.0;
    Content content_{};
    std::unique_ptr<std::array<Piece, std::size_t{1} << dimensions>> parts_{};
    std::atomic<PieceState> state_{};
    std::once_flag computed_;
};

/// The pieces of a table: a few roots, each halved along every axis until its parts are decided, and an index
/// of the parts that some divisions of the roots give.
template <class PieceType, std::size_t roots, int divisions_in_index, int most_divisions>
class PieceTree {
  public:
    using Content = typename PieceType::Content;
    using Place = typename PieceType::Place;

    virtual ~PieceTree() = default;

  protected:
    static constexpr int index_depth = divisions_in_index;
    static constexpr std::size_t slots_of_root = std::size_t{1} << (index_depth * PieceType::axes);
    static constexpr std::size_t slots = roots * slots_of_root;

    /// The piece that contains a place; it is tabulated, captured or undecided. @param slot the place's in
    /// the index
    [[nodiscard]] const PieceType* find(const Place& place, std::size_t slot) {
        PieceType* piece = index_[slot].load(std::memory_order_acquire);
        if (piece == nullptr) piece = &enter(place, slot);
        int depth = index_depth;
        while (true) {
            const PieceState state = piece->state();
            if (state == PieceState::unknown) {
                compute(*piece, depth);
            } else if (state == PieceState::divided) {
                piece = &piece->part(place);
                ++depth;
            } else {
                return piece;
            }
        }
    }

    std::array<PieceType, roots> roots_;

  private:
    /// Decides a piece and fills its content; unknown if it has to be divided. @param depth divisions of its
    /// root
    [[nodiscard]] virtual PieceState judge(const PieceType& piece, int depth, Content& content) const = 0;
    void compute(PieceType& piece, int depth) {
        piece.compute(depth == most_divisions,
                      [&](Content& content) { return judge(piece, depth, content); });
    }
    /// Enters the piece that contains a place, of index_depth or larger, into the index.
    PieceType& enter(const Place& place, std::size_t slot) {
        PieceType* piece = &roots_[slot / slots_of_root];
        for (int depth = 0; depth < index_depth; ++depth) {
            if (piece->state() == PieceState::unknown) compute(*piece, depth);
            if (piece->state() != PieceState::divided) break;
            piece = &piece->part(place);
        }
        index_[slot].store(piece, std::memory_order_release);
        return *piece;
    }

    std::array<std::atomic<PieceType*>, slots> index_{};
};

}  // namespace ashimpact::batch
