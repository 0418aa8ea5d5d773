// A Slurm cluster of this machine alone that lives as long as a test: munged, slurmctld and slurmd
// run as this user in a temporary folder, on ports of their own, and need neither systemd nor
// cgroups nor a configuration that is installed.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace wrinkle::test {

class Slurm {
public:
    // The folder's path is short, as sockets' names are. Jobs get the environment of sbatch.
    explicit Slurm(const std::filesystem::path& folder);
    ~Slurm();
    Slurm(const Slurm&) = delete;
    Slurm& operator=(const Slurm&) = delete;

    // For sbatch and its like.
    std::string environment() const { return "SLURM_CONF=" + (folder_ / "slurm.conf").string(); }
    // What the daemons say, for a message.
    std::string log() const;

private:
    // Runs till the cluster is gone; what it says goes to NAME.log.
    void start(const std::vector<std::string>& command);
    void configure() const;

    std::filesystem::path folder_;
    std::vector<pid_t> daemons_;
};

}  // namespace wrinkle::test
