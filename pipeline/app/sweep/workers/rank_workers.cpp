// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/workers/rank_workers.hpp"

#include <algorithm>
#include <thread>

#include "pipeline/app/sweep/workers/bytes.hpp"

namespace ashimpact {

namespace {

enum Tag : int { greeting, assignment, result, dismissal };

/// Time between polls for messages. Every worker has a block waiting, so no message is urgent, and each poll
/// takes time from a computing thread.
constexpr std::chrono::milliseconds pause{2};

template <class Value>
std::string packed(Value value) {
    ByteWriter writer;
    writer(value);
    return std::move(writer).take();
}

template <class Value>
Value unpacked(const std::string& bytes) {
    Value value{};
    ByteReader reader(bytes);
    reader(value);
    reader.finish();
    return value;
}

}  // namespace

RankWorkers::RankWorkers(Workers& own, const MpiSession& session)
    : own_(own), session_(session), others_(static_cast<std::size_t>(session.size())) {}

std::size_t RankWorkers::capacity() const {
    std::size_t capacity = own_.capacity();
    for (const Rank& other : others_) capacity += other.capacity;
    return capacity;
}

std::size_t RankWorkers::vacancies() const {
    std::size_t vacancies = own_.vacancies();
    for (const Rank& other : others_) vacancies += other.capacity - other.assigned;
    return vacancies;
}

void RankWorkers::assign(const Block& block) {
    const auto idle = std::max_element(others_.begin(), others_.end(), [](const Rank& a, const Rank& b) {
        return a.capacity - a.assigned < b.capacity - b.assigned;
    });
    if (own_.vacancies() >= idle->capacity - idle->assigned) {
        own_.assign(block);
        return;
    }
    ++idle->assigned;
    session_.send(static_cast<int>(idle - others_.begin()), assignment, packed(block));
}

std::optional<FinishedBlock> RankWorkers::finished(std::chrono::microseconds patience) {
    if (session_.size() == 1) return own_.finished(patience);
    const auto end = std::chrono::steady_clock::now() + patience;
    do {
        if (auto done = received()) return done;
        if (auto done = own_.finished(pause)) return done;
    } while (std::chrono::steady_clock::now() < end);
    return std::nullopt;
}

std::optional<FinishedBlock> RankWorkers::received() {
    while (auto message = session_.receive()) {
        Rank& sender = others_[static_cast<std::size_t>(message->rank)];
        if (message->tag == result) {
            --sender.assigned;
            return unpacked<FinishedBlock>(message->bytes);
        }
        sender.capacity = unpacked<std::uint64_t>(message->bytes);
    }
    return std::nullopt;
}

void RankWorkers::dismiss() const {
    for (int rank = 1; rank < session_.size(); ++rank) session_.send(rank, dismissal, {});
}

void serve(Workers& own, const MpiSession& session) {
    session.send(0, greeting, packed(std::uint64_t{own.capacity()}));
    for (;;) {
        while (const auto message = session.receive()) {
            if (message->tag == dismissal) return;
            own.assign(unpacked<Block>(message->bytes));
        }
        if (auto done = own.finished(pause)) session.send(0, result, packed(std::move(*done)));
    }
}

}  // namespace ashimpact
