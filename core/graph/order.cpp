#include "graph/order.h"

#include "base/text.h"
#include "graph/depth_first.h"
#include "graph/renamed.h"

namespace wrinkle {
namespace {

constexpr size_t shown = 8;                                    // nodes of a cycle in a diagnostic
constexpr size_t max_cycles = Diagnostics::default_limit + 1;  // further cycles are not reported

static_assert(static_cast<uint32_t>(Table<NodePtr>::npos) == Wires::none);

// Searches all nodes; calls `close_cycle` as DepthFirst::visit() does.
template <class CloseCycle>
void search(DepthFirst& walk, const Document& document, const Wires& wires,
            CloseCycle close_cycle) {
    for (uint32_t i = 0; i < document.nodes.size(); ++i)
        walk.visit(
            i, [&](uint32_t node) { return wires.of(node).size(); },
            [&](uint32_t node, uint32_t input) { return wires.of(node)[input]; }, close_cycle);
}

// `path` begins at the node that is read again; its middle is left out if it is long.
std::string cycle_text(const Document& document, std::span<const DepthFirst::Frame> path) {
    const auto id = [&](size_t i) { return "'" + document.nodes[path[i].node]->id + "'"; };
    std::string text = "the wires form a cycle: ";
    for (size_t i = 0; i < path.size(); ++i) {
        const bool omitted = i >= shown / 2 && i + shown / 2 < path.size();
        if (!omitted)
            text += id(i) + " reads ";
        else if (i == shown / 2)
            text += "... (" + std::to_string(path.size() - shown) + " more) reads ";
    }
    return text + id(0);
}

// Suggests names, within a budget so that a large graph with many errors is still read quickly.
template <class T>
class Names {
public:
    explicit Names(const Table<T>& table) : table_(table) {}

    std::string remedy(std::string_view word, const char* otherwise) {
        if (table_.size() > budget_) return otherwise;
        budget_ -= table_.size();
        if (names_.empty()) names_ = keys_of(table_);
        return did_you_mean(word, names_, otherwise);
    }

private:
    const Table<T>& table_;
    std::vector<std::string> names_;
    size_t budget_ = 200'000;
};

class Checker {
public:
    Checker(const Document& document, const Wires& wires, Diagnostics& diagnostics)
        : document_(document),
          diagnostics_(diagnostics),
          wires_(wires),
          ids_(document.nodes),
          inputs_(document.inputs) {}

    void run() {
        bool forward = false;  // a node reads itself or a later node: required for a cycle
        for (size_t n = 0; n < document_.nodes.size(); ++n) {
            const Node& node = *document_.nodes[n];
            const auto read = wires_.of(n);
            for (size_t i = 0; i < read.size(); ++i) {
                if (read[i] == Wires::none) check_port(node, node.inputs[i]);
                forward |= read[i] != Wires::none && read[i] >= n;
            }
        }
        for (const Output& output : document_.outputs)
            check(output.from.link, [&](RuleId rule, std::string message, std::string expected) {
                return diagnose(document_, output, rule, std::move(message), std::move(expected));
            });
        if (forward) report_cycles();
    }

private:
    void check_port(const Node& node, const Input& input) {
        check(input.link, [&](RuleId rule, std::string message, std::string expected) {
            return diagnose_port(document_, node, input.port, rule, std::move(message),
                                 std::move(expected));
        });
    }

    template <class Diagnose>
    void check(const Link& link, Diagnose diagnose_here) {
        const bool lost_node = link.is_node() && !document_.find(link.node);
        const bool lost_input = link.is_input() && !document_.inputs.find(link.port);
        if (!lost_node && !lost_input) return;
        if (diagnostics_.dropped() > 0) return diagnostics_.add({});  // only counted
        if (lost_node)
            diagnostics_.add(diagnose_here(RuleId::unknown_source,
                                           "there is no node '" + link.node + "'",
                                           ids_.remedy(link.node, "expected the id of a node")));
        else
            diagnostics_.add(diagnose_here(RuleId::unknown_source,
                                           "the graph has no input '" + link.port + "'",
                                           remedy(link.port)));
    }

    std::string remedy(const std::string& input) {
        const std::string current(FormerNames(document_.inputs).current(input));
        return current.empty() ? inputs_.remedy(input, "declare it under \"inputs\"")
                               : "it is called '" + current + "' now";
    }

    void report_cycles() {
        DepthFirst walk(document_.nodes.size());
        size_t cycles = 0;
        search(walk, document_, wires_, [&](uint32_t index, uint32_t input, uint32_t target) {
            if (++cycles > max_cycles) return;
            const std::span<const DepthFirst::Frame> path = walk.path();
            size_t begin = path.size() - 1;
            while (path[begin].node != target)
                --begin;
            const Node& node = *document_.nodes[index];
            diagnostics_.add(diagnose_port(document_, node, node.inputs[input].port, RuleId::cycle,
                                           cycle_text(document_, path.subspan(begin)),
                                           "remove one of these wires"));
        });
    }

    const Document& document_;
    Diagnostics& diagnostics_;
    const Wires& wires_;
    Names<NodePtr> ids_;
    Names<GraphInput> inputs_;
};

}  // namespace

Wires::Wires(const Document& document) {
    first_.reserve(document.nodes.size() + 1);
    for (const NodePtr& node : document.nodes) {
        first_.push_back(static_cast<uint32_t>(read_.size()));
        for (const Input& input : node->inputs)
            read_.push_back(input.link.is_node()
                                ? static_cast<uint32_t>(document.nodes.index_of(input.link.node))
                                : none);
    }
    first_.push_back(static_cast<uint32_t>(read_.size()));
}

std::vector<uint32_t> evaluation_order(const Document& document) {
    DepthFirst walk(document.nodes.size());
    search(walk, document, Wires(document), [](uint32_t, uint32_t, uint32_t) {});
    return std::move(walk.order());
}

Wires check_links(const Document& document, Diagnostics& diagnostics) {
    Wires wires(document);
    Checker(document, wires, diagnostics).run();
    return wires;
}

}  // namespace wrinkle
