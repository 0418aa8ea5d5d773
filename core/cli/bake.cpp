// wrinkle bake FILE --mesh NAME|PATH -o OUT: bakes a graph's maps onto the uv layout of a mesh.
#include "cli/arguments.h"
#include "cli/bake_run.h"
#include "cli/cli.h"
#include "cli/output.h"
#include "image/formats.h"
#include "json/write.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

struct BakeCommand {
    BakeOptions options;

    int run() const {
        catch_interruption();
        if (!options.merge.empty()) return merge();
        BakeRequest request;
        std::string why = read_request(options, request);
        if (!why.empty()) return fail(exit_usage, why);
        Diagnostics diagnostics;
        auto job = make_bake_job(options, request, diagnostics);
        if (!job) return report(diagnostics, options.common.diagnostics);
        const PartHeader header = header_of(*job);
        if (!request.is_shard() && !can_be_written(header, why)) return fail(exit_usage, why);
        if (!may_be_written(*job, header, diagnostics))
            return report(diagnostics, options.common.diagnostics);
        BakeOutcome outcome = carry_out(*job, header);
        diagnostics.append(outcome.warnings);
        report(diagnostics, options.common.diagnostics);
        return write_depfile(*job, outcome) ? finish(outcome) : int{exit_environment};
    }

    // Checks file formats before the bake, which may take hours.
    bool can_be_written(const PartHeader& header, std::string& why) const {
        for (const MapFile& file : header.files(options.output, 0, options.threads)) {
            if (!file.path.has_extension()) {
                why = file.path.string() +
                      " has no extension to choose the format by; the file of one map has one, "
                      "such as " +
                      file.path.string() + ".png";
                return false;
            }
            const WriteProblem problem =
                find_write_problem(format_to_write(file.path), file.options);
            if (problem.message.empty()) continue;
            why = file.path.string() + " " + problem.message +
                  (problem.expected.empty() ? "" : " (" + problem.expected + ")");
            return false;
        }
        return true;
    }

    std::string depfile_path() const {
        return options.depfile.path.empty() ? options.output + ".d" : options.depfile.path;
    }

    // Returns false and reports an error if an output would overwrite an input, or if a name cannot
    // be written to the dependency file.
    bool may_be_written(const BakeJob& job, const PartHeader& header,
                        Diagnostics& diagnostics) const {
        std::vector<std::string> paths;
        for (size_t set = 0; header.shards == 1 && set < job.sets.size(); ++set)
            for (const MapFile& file : header.files(options.output, set, options.threads))
                paths.push_back(file.path.string());
        std::string why;
        if (options.depfile.wanted) why = depfile_fault({{paths, job.inputs}}, options.depfile);
        if (options.depfile.wanted) paths.push_back(depfile_path());
        if (why.empty()) why = overwrite_fault_of_run(paths, job.inputs);
        if (!why.empty()) diagnostics.error(RuleId::output_path, why);
        return why.empty();
    }

    BakeOutcome carry_out(const BakeJob& job, const PartHeader& header) const {
        uint64_t texels = 0;
        for (uint64_t band = header.first; band < header.last; ++band)
            texels += uint64_t{header.rows_of(band)} * header.width();
        Progress progress(Progress::form_for(options.json), texels);
        if (header.shards > 1) return bake_part(job, options.output, header, progress);
        if (!options.resume) return bake_files(job, header, progress);
        const std::string folder = options.output + ".part";
        BakeOutcome outcome = bake_part(job, folder, header, progress);
        if (!outcome.done) return outcome;
        outcome.done = false;
        const auto parts = read_parts({folder}, outcome.environment);
        if (parts.empty()) return outcome;
        Progress quiet(Progress::Form::none, 0);
        BakeOutcome joined = join_parts(parts, options.output, options.threads, quiet);
        joined.warnings = std::move(outcome.warnings);
        std::error_code ignored;
        if (joined.done) fs::remove_all(folder, ignored);
        return joined;
    }

    // Writes the outputs and inputs of a finished bake; returns false if the write fails.
    bool write_depfile(const BakeJob& job, const BakeOutcome& outcome) const {
        const Depfile& depfile = options.depfile;
        if (!depfile.wanted || !outcome.done) return true;
        return write_result(depfile_path(), make_rules({{outcome.files, job.inputs}}, depfile)) ==
               exit_success;
    }

    int merge() const {
        if (!options.file.empty() || !options.mesh.empty() || !options.shard.empty() ||
            options.resume)
            return fail(exit_usage,
                        "--merge joins what was baked; it takes folders and -o OUT alone");
        Diagnostics diagnostics;
        const auto parts = read_parts(options.merge, diagnostics);
        if (parts.empty()) return report(diagnostics, options.common.diagnostics);
        const PartHeader& header = parts[0].header;
        std::string why;
        if (!can_be_written(header, why)) return fail(exit_usage, why);
        BakeOutcome outcome;
        {
            Progress progress(Progress::form_for(options.json),
                              header.sets.size() * uint64_t{header.width()} * header.height());
            outcome = join_parts(parts, options.output, options.threads, progress);
        }
        return finish(outcome);
    }

    int finish(const BakeOutcome& outcome) const {
        if (!outcome.done && !outcome.environment.has_errors()) reraise_interruption();
        if (!outcome.done) {
            report(outcome.environment, options.common.diagnostics);
            return exit_environment;
        }
        if (!options.json) return exit_success;
        return write_result("-", "{\"files\": " + json::string_array(outcome.files) + "}\n");
    }
};

}  // namespace

void declare_bake(CLI::App& app, Run& run) {
    auto [sub, c] =
        add_command<BakeCommand>(app, run, "bake", "A graph's maps on the uv layout of a mesh");
    declare_bake_options(sub, c.options);
}

}  // namespace wrinkle::cli
