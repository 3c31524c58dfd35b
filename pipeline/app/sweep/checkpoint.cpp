// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/app/sweep/checkpoint.hpp"

#include "core/text/error.hpp"
#include "core/version.hpp"
#include "pipeline/app/sweep/workers/bytes.hpp"
#include "pipeline/files/file.hpp"
#include "pipeline/files/sha256.hpp"

namespace ashimpact {

namespace {

/// Header of a checkpoint; it must agree before a sweep continues from it.
struct Owner {
    std::string format = std::string(checkpoint_mark) + " 2";
    std::string version{program_version()};
    std::string revision{program_revision()};
    std::string spec;

    template <class Archive>
    void transfer(Archive& archive) {
        archive(format, version, revision, spec);
    }
};

}  // namespace

void save_checkpoint(const std::filesystem::path& file, const SweepPlan& plan, Checkpoint checkpoint) {
    ByteWriter body;
    body(checkpoint);
    std::string bytes = std::move(body).take();
    std::string digest = sha256(bytes);
    Owner owner{.spec = plan.hash()};
    ByteWriter whole;
    whole(owner, digest, bytes);
    write_file(file, std::move(whole).take());
}

std::optional<Checkpoint> load_checkpoint(const std::filesystem::path& file, const SweepPlan& plan) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return std::nullopt;
    const auto refuse = [&](const char* problem) {
        throw InputError(problem, "--restart to begin anew, or another -o").at(FileName{file.string()});
    };
    const std::string content = read_file(file);
    Owner owner;
    std::string digest;
    std::string bytes;
    Checkpoint checkpoint;
    try {
        ByteReader whole(content);
        whole(owner, digest, bytes);
        whole.finish();
        if (owner.format != Owner{}.format || digest != sha256(bytes)) throw BrokenBytes();
        if (owner.version != program_version() || owner.revision != program_revision())
            refuse("is the checkpoint of another version of ashimpact");
        if (owner.spec != plan.hash()) refuse("is the checkpoint of another sweep");
        ByteReader body(bytes);
        body(checkpoint);
        body.finish();
    } catch (const BrokenBytes&) {
        refuse("is no checkpoint, or damaged");
    }
    return checkpoint;
}

}  // namespace ashimpact
