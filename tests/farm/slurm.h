// A Slurm cluster on this machine for the lifetime of a test: munged, slurmctld and slurmd run as
// this user in a temporary folder, on their own ports, without systemd, cgroups or an installed
// configuration.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace wrinkle::test {

class Slurm {
public:
    // Precondition: the path of `folder` is short, as socket paths are limited. Jobs get the
    // environment of sbatch.
    explicit Slurm(const std::filesystem::path& folder);
    ~Slurm();
    Slurm(const Slurm&) = delete;
    Slurm& operator=(const Slurm&) = delete;

    // Environment entry for sbatch and other Slurm commands.
    std::string environment() const { return "SLURM_CONF=" + (folder_ / "slurm.conf").string(); }
    // Returns the logs of the daemons.
    std::string log() const;

private:
    // Starts a daemon that runs until the destructor stops it; its output goes to NAME.log.
    void start(const std::vector<std::string>& command);
    void configure() const;

    std::filesystem::path folder_;
    std::vector<pid_t> daemons_;
};

}  // namespace wrinkle::test
