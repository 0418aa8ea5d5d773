"""Static cost of a disassembled SPIR-V module, as left by `spirv-opt -O`.

The rule: every instruction of every function counts once, also in loops; no call may remain.

    tex        sampling, fetching, gathering, reading an image: 1 each
    query      questions about an image (its size, a level): 1 each
    deriv      screen derivatives; deriv_lanes the numbers they give
    alu        numbers computed: arithmetic, comparison, choice, logic, bits, conversion give the
               lanes of their result; dot of n: 2n-1; matrix (r rows, c columns) times vector:
               (2c-1)r; clamp and fma 2 a lane, mix 3, smoothstep 7, pow 3, cross 9,
               length 2n, normalize 3n
    trans      sqrt, inversesqrt, exp, log, sin, ... a lane; 1 of a length or normalize; 2 a lane of pow
    div        divided lanes (they are in alu too)
    branch     conditional branches; loop: loops
    free       loads, stores, extraction, insertion, shuffles, construction, phis, labels

Multiplications and additions are not fused.
"""
import collections
import re

ONE_A_LANE = re.compile(
    r"Op(F(Add|Sub|Mul|Div|Negate|Rem|Mod|Convert)|I(Add|Sub|Mul)|[SU](Div|Mod|Rem|Negate|Convert)"
    r"|Not|Shift\w+|Bit\w+|Convert\w+|Select|Logical\w+|Is(Nan|Inf)|VectorTimesScalar"
    r"|MatrixTimesScalar|OuterProduct"
    r"|(FOrd|FUnord|S|U|I)(Equal|NotEqual|LessThan|GreaterThan)(Equal)?)$")
TEXTURE = re.compile(r"OpImage(Sparse)?(Sample|Fetch|Gather|DrefGather|Read)")
TRANSCENDENTAL = {"Sqrt", "InverseSqrt", "Exp", "Exp2", "Log", "Log2", "Sin", "Cos", "Tan", "Asin",
                  "Acos", "Atan", "Atan2"}
BY_LANE = {"FClamp": 2, "NClamp": 2, "SClamp": 2, "UClamp": 2, "Fma": 2, "FMix": 3,
           "SmoothStep": 7, "Pow": 3}
COLUMNS = ("alu", "trans", "div", "tex", "query", "deriv", "deriv_lanes", "branch", "loop")


class _Types:
    """Shapes of results: (rows, columns), a scalar being (1, 1) and a vector (n, 1)."""

    def __init__(self):
        self.shape_of_type = {}
        self.type_of = {}

    def declare(self, result, op, words):
        if op in ("OpTypeFloat", "OpTypeInt", "OpTypeBool"):
            self.shape_of_type[result] = (1, 1)
        elif op == "OpTypeVector":
            self.shape_of_type[result] = (int(words[1]), 1)
        elif op == "OpTypeMatrix":
            self.shape_of_type[result] = (self.shape_of_type[words[0]][0], int(words[1]))
        if result and words and words[0] in self.shape_of_type:
            self.type_of[result] = words[0]

    def shape(self, value):
        return self.shape_of_type.get(self.type_of.get(value), (1, 1))

    def lanes(self, value):
        rows, columns = self.shape(value)
        return rows * columns


def _extended(name, lanes, operand_lanes, cost):
    if name == "Cross":
        return 9
    if name in ("Length", "Distance"):
        cost["trans"] += 1
        return 2 * operand_lanes + (operand_lanes if name == "Distance" else 0)
    if name == "Normalize":
        cost["trans"] += 1
        return 3 * operand_lanes
    if name in TRANSCENDENTAL:
        cost["trans"] += lanes
    if name == "Pow":
        cost["trans"] += 2 * lanes
    return lanes * BY_LANE.get(name, 1)


def _product(op, words, types):
    """Of a matrix with a vector or a matrix: each number is a dot product."""
    left, right = types.shape(words[1]), types.shape(words[2])
    if op == "OpVectorTimesMatrix":
        return (2 * right[0] - 1) * right[1]
    return (2 * left[1] - 1) * left[0] * right[1]


def _count_instruction(result, op, words, types, cost):
    lanes = types.lanes(result) if result else 1
    if op == "OpFunctionCall":
        raise ValueError("a call is left: not optimised")
    if TEXTURE.match(op):
        cost["tex"] += 1
    elif op.startswith("OpImageQuery"):
        cost["query"] += 1
    elif op.startswith(("OpDPd", "OpFwidth")):
        cost["deriv"] += 1
        cost["deriv_lanes"] += lanes
    elif op in ("OpBranchConditional", "OpSwitch"):
        cost["branch"] += 1
    elif op == "OpLoopMerge":
        cost["loop"] += 1
    elif op == "OpDot":
        cost["alu"] += 2 * types.lanes(words[1]) - 1
    elif op in ("OpAny", "OpAll"):
        cost["alu"] += types.lanes(words[1])
    elif op in ("OpMatrixTimesVector", "OpVectorTimesMatrix", "OpMatrixTimesMatrix"):
        cost["alu"] += _product(op, words, types)
    elif op == "OpExtInst":
        cost["alu"] += _extended(words[2], lanes, types.lanes(words[3]), cost)
    elif ONE_A_LANE.match(op):
        cost["alu"] += lanes
        cost["div"] += lanes if op == "OpFDiv" else 0


def count(disassembly):
    """The cost of a module's functions, by the names of COLUMNS."""
    types, cost, inside = _Types(), collections.Counter(), False
    for line in disassembly.splitlines():
        found = re.match(r"\s*(?:(%\w+)\s*=\s*)?(Op\w+)\s*(.*)$", line.split(";")[0])
        if not found:
            continue
        result, op, words = found.group(1), found.group(2), found.group(3).split()
        types.declare(result, op, words)
        inside = inside or op == "OpFunction"
        if inside:
            _count_instruction(result, op, words, types, cost)
    return cost
