// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/workers/mpi_session.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>

#include <mpi.h>

#include "core/text/error.hpp"

namespace ashimpact {

namespace {

/// How many processes the launcher says there are; 0 without one. Open MPI; MPICH, Intel MPI and others.
int processes_launched() {
    for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS"})
        if (const char* value = std::getenv(variable))
            return static_cast<int>(std::strtol(value, nullptr, 10));
    return std::getenv("PMIX_RANK") != nullptr ? 1 : 0;
}

}  // namespace

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

}  // namespace ashimpact
