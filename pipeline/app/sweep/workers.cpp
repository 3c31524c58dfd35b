// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/workers.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include <mpi.h>
#include <sched.h>

#include "core/text/error.hpp"
#include "pipeline/app/sweep/bytes.hpp"

namespace ashimpact {

namespace {

/// How many processes the launcher says there are; 0 without one. Open MPI; MPICH, Intel MPI and others.
int processes_launched() {
    for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS"})
        if (const char* value = std::getenv(variable))
            return static_cast<int>(std::strtol(value, nullptr, 10));
    return std::getenv("PMIX_RANK") != nullptr ? 1 : 0;
}

enum Tag : int { greeting, assignment, result, dismissal };

/// Time between polls. Workers have a block waiting, so no message is urgent.
constexpr std::chrono::milliseconds pause{2};

}  // namespace

ThreadWorkers::ThreadWorkers(int threads, Work work) : work_(std::move(work)) {
    for (int i = 0; i < threads; ++i)
        threads_.emplace_back([this](const std::stop_token& stop) { serve(stop); });
}

ThreadWorkers::~ThreadWorkers() {
    for (std::jthread& thread : threads_) thread.request_stop();
    for (std::jthread& thread : threads_) thread.join();
}

void ThreadWorkers::assign(const Block& block) {
    ++assigned_;
    const std::lock_guard lock(mutex_);
    waiting_.push_back(block);
    waiting_changed_.notify_one();
}

void ThreadWorkers::serve(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (waiting_changed_.wait(lock, stop, [this] { return !waiting_.empty(); }) &&
           !stop.stop_requested()) {
        FinishedBlock done{.block = waiting_.front(), .seconds = 0, .bytes = {}};
        waiting_.pop_front();
        lock.unlock();
        std::exception_ptr failure;
        const auto start = std::chrono::steady_clock::now();
        try {
            done.bytes = work_(done.block);
        } catch (...) {
            failure = std::current_exception();
        }
        done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        lock.lock();
        if (failure)
            failure_ = failure;
        else
            finished_.push_back(std::move(done));
        finished_changed_.notify_one();
    }
}

std::optional<FinishedBlock> ThreadWorkers::finished(std::chrono::microseconds patience) {
    std::unique_lock lock(mutex_);
    finished_changed_.wait_for(lock, patience, [this] { return failure_ != nullptr || !finished_.empty(); });
    if (failure_) std::rethrow_exception(failure_);
    if (finished_.empty()) return std::nullopt;
    FinishedBlock done = std::move(finished_.front());
    finished_.pop_front();
    --assigned_;
    return done;
}

int default_threads(int processes_here) {
    cpu_set_t bound;  // the cores this process is bound to
    const bool known = sched_getaffinity(0, sizeof(bound), &bound) == 0;
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return std::max(1, std::min(known ? CPU_COUNT(&bound) : cores, cores / std::max(processes_here, 1)));
}

void MpiSession::join() {
    const int launched = processes_launched();
    if (launched == 0) return;
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    joined_ = true;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    MPI_Comm here = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
    MPI_Comm_size(here, &size_here_);
    MPI_Comm_free(&here);
    if (size_ < launched)
        throw InputError(
            "mpirun started " + std::to_string(launched) + " processes that do not find each other",
            "the mpirun of Open MPI, which this program is built with");
    if (provided < MPI_THREAD_FUNNELED) throw std::runtime_error("this MPI does not allow threads beside it");
}

int MpiSession::leave(int status) {
    if (!joined_) return status;
    joined_ = false;
    if (status == 0)
        MPI_Finalize();
    else
        MPI_Abort(MPI_COMM_WORLD, status);
    return status;
}

std::string MpiSession::broadcast(const std::string& text) const {
    if (size_ == 1) return text;
    std::uint64_t length = text.size();
    MPI_Bcast(&length, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    std::string copy = text;
    copy.resize(length);
    MPI_Bcast(copy.data(), static_cast<int>(length), MPI_CHAR, 0, MPI_COMM_WORLD);
    return copy;
}

void MpiSession::send(int rank, int tag, const std::string& bytes) const {
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, tag, MPI_COMM_WORLD);
}

std::optional<Message> MpiSession::receive() const {
    if (size_ == 1) return std::nullopt;
    int arrived = 0;
    MPI_Status status{};
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &arrived, &status);
    if (arrived == 0) return std::nullopt;
    int length = 0;
    MPI_Get_count(&status, MPI_BYTE, &length);
    Message message{status.MPI_SOURCE, status.MPI_TAG, std::string(static_cast<std::size_t>(length), '\0')};
    MPI_Recv(message.bytes.data(), length, MPI_BYTE, message.rank, message.tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return message;
}

RankWorkers::RankWorkers(Workers& own, const MpiSession& session)
    : own_(own), session_(session), others_(static_cast<std::size_t>(session.size())) {}

std::size_t RankWorkers::capacity() const {
    std::size_t capacity = own_.capacity();
    for (const Rank& other : others_) capacity += other.capacity;
    return capacity;
}

std::size_t RankWorkers::vacancies() const {
    std::size_t vacancies = own_.vacancies();
    for (const Rank& other : others_) vacancies += other.vacancies();
    return vacancies;
}

void RankWorkers::assign(const Block& block) {
    const auto idle = std::ranges::max_element(others_, {}, &Rank::vacancies);
    if (own_.vacancies() >= idle->vacancies()) {
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
