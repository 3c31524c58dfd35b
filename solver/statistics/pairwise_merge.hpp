// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace ashimpact {

/// Merges the sums of chunks in the order of a fixed binary tree, keeping at most one node of each level.
///
/// Floating-point sums depend on their order. Here the order depends on the number of chunks alone: chunks 2i
/// and 2i + 1 merge, then pairs of such pairs, and so on, whoever computed them. A part of 2^level chunks
/// that begins at a multiple of 2^level is a node of that tree and may be merged elsewhere first.
/// @tparam Sums has merge(const Sums&) and transfer(archive)
template <class Sums>
class PairwiseMerge {
  public:
    /// Adds the next node: 2^@p level chunks, next after those added before.
    void add(Sums sums, unsigned level = 0) {
        nodes_.push_back({level, std::move(sums)});
        while (nodes_.size() > 1 && nodes_[nodes_.size() - 2].level == nodes_.back().level) {
            const Node right = std::move(nodes_.back());
            nodes_.pop_back();
            nodes_.back().sums.merge(right.sums);
            ++nodes_.back().level;
        }
    }

    /// Everything added so far, merged; needs one node.
    [[nodiscard]] Sums total() const {
        Sums total = nodes_.back().sums;
        for (std::size_t i = nodes_.size() - 1; i-- > 0;) {
            Sums left = nodes_[i].sums;
            left.merge(total);
            total = std::move(left);
        }
        return total;
    }

    [[nodiscard]] std::size_t nodes() const { return nodes_.size(); }

    template <class Archive>
    void transfer(Archive& archive) {
        archive(nodes_);
    }

  private:
    struct Node {
        unsigned level = 0;
        Sums sums;

        template <class Archive>
        void transfer(Archive& archive) {
            archive(level, sums);
        }
    };
    std::vector<Node> nodes_;
};

}  // namespace ashimpact
