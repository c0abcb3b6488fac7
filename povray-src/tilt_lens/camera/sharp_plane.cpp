// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/sharp_plane.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

namespace
{

/// Relative; far above Real's rounding, far below doubles'.
const double kSameDeviation = 1e-24;

/// An equation after a part of k is known.
struct Row
{
    RealVec direction;  ///< perpendicular to everything known; zero if only rounding
    Real vergence;
    Real rounding;      ///< greatest length that counts as zero

    bool Empty() const { return direction.x == 0 && direction.y == 0 && direction.z == 0; }
};

/// Span of some rows' directions, and the k in it with given residuals.
class Span
{
  public:
    /// Part perpendicular to the span; zero if only rounding.
    RealVec Beside(const Row& row) const
    {
        RealVec beside = row.direction;
        for (int turn = 0; turn < 2; turn++)  // the second turn removes the first's rounding
            for (const RealVec& unit : basis)
                beside = beside - Dot(beside, unit) * unit;
        return Length(beside) > row.rounding ? beside : RealVec();
    }

    bool Holds(const Row& row) const { return Row{Beside(row), 0, 0}.Empty(); }

    void Add(const Row& row, const Real& residual = 0)
    {
        const RealVec unit = Normalized(Beside(row));
        k = k + ((row.vergence - residual - Dot(k, row.direction)) / Dot(unit, row.direction)) * unit;
        basis.push_back(unit);
    }

    Row Rest(const Row& row) const { return {Beside(row), row.vergence - Dot(k, row.direction), row.rounding}; }

    RealVec k{};

  private:
    std::vector<RealVec> basis;
};

using Rows = std::vector<Row>;
using Indices = std::vector<std::size_t>;

/// Empty for independent rows.
struct Circuit
{
    Indices rows;
    std::vector<Real> weights;  ///< magnitudes sum to 1; signs of the residuals
    Real deviation = 0;         ///< least of its rows, not negative
};

/// @param independent  their span holds the row `last`
Circuit CircuitOf(const Rows& rows, const Indices& independent, std::size_t last)
{
    Circuit circuit;
    Real sum = 1;
    for (std::size_t i : independent)
    {
        Span others;
        for (std::size_t other : independent)
            if (other != i)
                others.Add(rows[other]);
        if (others.Holds(rows[last]))
            continue;
        const RealVec beside = others.Beside(rows[i]);
        circuit.rows.push_back(i);
        circuit.weights.push_back(Dot(rows[last].direction, beside) / Dot(rows[i].direction, beside));
        sum += abs(circuit.weights.back());
    }
    circuit.rows.push_back(last);
    circuit.weights.push_back(-1);
    for (std::size_t i = 0; i < circuit.rows.size(); i++)
        circuit.deviation += circuit.weights[i] * rows[circuit.rows[i]].vergence;
    const Real scale = (circuit.deviation < 0 ? -1 : 1) / sum;
    circuit.deviation *= scale;
    for (Real& weight : circuit.weights)
        weight *= scale;
    return circuit;
}

Circuit FirstCircuit(const Rows& rows)
{
    Span span;
    Indices independent;
    for (std::size_t i = 0; i < rows.size(); i++)
    {
        if (span.Holds(rows[i]))
            return CircuitOf(rows, independent, i);
        span.Add(rows[i]);
        independent.push_back(i);
    }
    return {};
}

Circuit GreatestCircuit(const Rows& rows, const Indices& few)
{
    Circuit greatest;
    for (unsigned int chosen = 1; chosen < 1u << few.size(); chosen++)
    {
        Span span;
        Indices independent;
        std::optional<std::size_t> last;
        for (std::size_t i = 0; i < few.size(); i++)
        {
            if ((chosen >> i & 1) == 0)
                continue;
            if (last)
                span.Add(rows[*last]), independent.push_back(*last);
            last = few[i];
            if (span.Holds(rows[*last]))
                break;
        }
        if (!span.Holds(rows[*last]))
            continue;
        const Circuit circuit = CircuitOf(rows, independent, *last);
        if (circuit.rows.size() > 0 && (greatest.rows.empty() || circuit.deviation > greatest.deviation))
            greatest = circuit;
    }
    return greatest;
}

struct Solved
{
    RealVec k;
    Circuit circuit;
};

Solved StrictSolution(const Rows& rows, const Real& same);

/// Gives a circuit's rows its deviation; the free part of k solves the others, whose circuit is returned.
Solved SolveBeside(const Rows& rows, const Circuit& circuit, const Real& same)
{
    Span span;
    for (std::size_t i = 0; i + 1 < circuit.rows.size(); i++)
        span.Add(rows[circuit.rows[i]], circuit.weights[i] > 0 ? circuit.deviation : Real(-circuit.deviation));
    Rows rest;
    Indices indices;
    for (std::size_t i = 0; i < rows.size(); i++)
        if (std::find(circuit.rows.begin(), circuit.rows.end(), i) == circuit.rows.end())
        {
            rest.push_back(span.Rest(rows[i]));
            indices.push_back(i);
        }
    Solved solved = StrictSolution(rest, same);
    solved.k = solved.k + span.k;
    for (std::size_t& row : solved.circuit.rows)
        row = indices[row];
    return solved;
}

/// Exchanges circuits until none has a greater deviation.
/// @param rows  none empty
Solved SolveRows(const Rows& rows, const Real& same)
{
    Circuit circuit = FirstCircuit(rows);
    if (circuit.rows.empty())
    {
        Span span;
        for (const Row& row : rows)
            span.Add(row);
        return {span.k, circuit};
    }
    for (;;)
    {
        const Solved beside = SolveBeside(rows, circuit, same);
        if (!(beside.circuit.deviation > circuit.deviation + same))
            return {beside.k, circuit};
        Indices few = circuit.rows;
        few.insert(few.end(), beside.circuit.rows.begin(), beside.circuit.rows.end());
        const Circuit greater = GreatestCircuit(rows, few);
        if (!(greater.deviation > circuit.deviation))
            return {beside.k, beside.circuit};
        circuit = greater;
    }
}

Solved StrictSolution(const Rows& rows, const Real& same)
{
    Rows full;
    Indices indices;
    Circuit empty;
    for (std::size_t i = 0; i < rows.size(); i++)
        if (!rows[i].Empty())
        {
            full.push_back(rows[i]);
            indices.push_back(i);
        }
        else if (empty.rows.empty() || abs(rows[i].vergence) > empty.deviation)
            empty = {{i}, {rows[i].vergence < 0 ? -1 : 1}, abs(rows[i].vergence)};
    Solved solved = SolveRows(full, same);
    for (std::size_t& row : solved.circuit.rows)
        row = indices[row];
    if (empty.deviation > solved.circuit.deviation)
        solved.circuit = empty;
    return solved;
}

std::string Text(const Vec3& v)
{
    return "<" + Number(v.x) + ", " + Number(v.y) + ", " + Number(v.z) + ">";
}

/// As for focal_points.
bool OnOneLine(const std::vector<RealVec>& points)
{
    const auto apart = [&](const RealVec& point) { return Length(point - points[0]) > kDependent * Length(points[0]); };
    const auto second = std::find_if(points.begin(), points.end(), apart);
    if (second == points.end())
        return true;
    const RealVec line = Normalized(*second - points[0]);
    return std::none_of(points.begin(), points.end(), [&](const RealVec& point)
    { return apart(point) && Length(Cross(line, Normalized(point - points[0]))) > kDependent; });
}

void RequireBeforeLens(const RealVec& point, const Vec3& written, const Vec3& location)
{
    if (!IsFinite(written))
        throw OpticsError("sharp_points has the point " + Text(written) + ". All its numbers must be finite; check the expression.");
    if (!(point.z > kRounding * (Length(point) + Length(location))))
        throw OpticsError("sharp_points has the point " + Text(written) + ", which is not in front of the lens: it lies " +
                          Number(double(point.z)) +
                          " units along the camera's axis. No lens makes it sharp; move or remove it, or "
                          "move the camera back.");
}

Rows RowsOf(const std::vector<VergenceEquation>& equations)
{
    Rows rows;
    for (const VergenceEquation& equation : equations)
        rows.push_back({equation.direction, equation.vergence, kDependent * Length(equation.direction)});
    return rows;
}

} // namespace

bool SpanSpace(const std::vector<VergenceEquation>& equations)
{
    Span span;
    int dimensions = 0;
    for (const Row& row : RowsOf(equations))
        if (!span.Holds(row))
        {
            span.Add(row);
            dimensions++;
        }
    return dimensions == 3;
}

std::vector<VergenceEquation> VergenceEquations(const std::vector<RealVec>& points, const std::vector<Vec3>& written, const Vec3& location)
{
    std::vector<VergenceEquation> equations;
    for (std::size_t i = 0; i < points.size(); i++)
    {
        RequireBeforeLens(points[i], written[i], location);
        equations.push_back({points[i] / points[i].z, 1 / points[i].z});
    }
    if (SpanSpace(equations))
        return equations;
    const std::string way = ", so that nothing says how the plane of sharp focus turns about that line. Move one of them off it, or add "
                            "another point.";
    if (points.empty() || OnOneLine(points))
        throw OpticsError("All sharp_points lie on one line" +
                          (points.empty() ? "" : ", from " + Text(written.front()) + " to " + Text(written.back())) + way);
    throw OpticsError("All sharp_points lie in one plane with the lens centre, so that the picture has them on one line" + way);
}

Real GreatestResidual(const std::vector<VergenceEquation>& equations, const RealVec& k)
{
    Real greatest = 0;
    for (const VergenceEquation& equation : equations)
        greatest = std::max<Real>(greatest, abs(equation.vergence - Dot(k, equation.direction)));
    return greatest;
}

RealVec LeastGreatestBlur(const std::vector<VergenceEquation>& equations)
{
    const Real same = kSameDeviation * GreatestResidual(equations, {});
    return StrictSolution(RowsOf(equations), same).k;
}

} // namespace tilt_lens
