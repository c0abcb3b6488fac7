// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#define BOOST_BIND_GLOBAL_PLACEHOLDERS  // as the program has it; the library's parser prints a note without

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include "tilt_lens/camera/numbers.h"
#include "tilt_lens/glass/prescription_rows.h"

namespace tilt_lens
{

namespace
{

using Tree = boost::property_tree::ptree;

/// Beyond this radius (mm) the shader's files mean a plane.
constexpr double kPlaneRadius = 99999.0;

const char* const kKnown = "Known are lentil's form, with \"optical-elements-patent\", and that of ISET, with \"surfaces\".";

/// Lines in which the objects of a list begin. The parser of the library forgets where it found things, so they are counted
/// here: from the first `[` behind the list's name, objects directly within it.
class ListLines
{
  public:
    /// @param from  where the search for the name begins
    ListLines(const std::string& text, std::size_t from, const std::string& name)
    {
        std::size_t at = text.find('"' + name + '"', from);
        at = at == std::string::npos ? text.size() : text.find('[', at);
        int line = at == std::string::npos ? 1 : 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
        int depth = 0;
        bool quoted = false;
        for (; at < text.size(); at++)
        {
            const char c = text[at];
            line += c == '\n';
            if (quoted)
            {
                at += c == '\\';
                quoted = c != '"';
                continue;
            }
            quoted = c == '"';
            if (c == '{' && depth == 1)
                lines.push_back(line);
            depth += (c == '{' || c == '[') - (c == '}' || c == ']');
            if (depth <= 0)
                break;
        }
    }

    int Of(std::size_t number) const { return number < lines.size() ? lines[number] : 0; }

  private:
    std::vector<int> lines;
};

/// An object's members, of which numbers are asked.
class Members
{
  public:
    Members(const Tree& tree, int line) : tree(tree), line(line) {}

    bool Has(const char* name) const
    {
        const auto found = tree.find(name);
        return found != tree.not_found() && !(found->second.empty() && found->second.data() == "null");
    }

    std::string Text(const char* name) const { return Has(name) ? tree.find(name)->second.data() : std::string(); }

    double Number(const char* name) const
    {
        if (!Has(name))
            throw PrescriptionError(line, "a surface without \"" + std::string(name) + "\", which must be a number.");
        const Tree& member = tree.find(name)->second;
        // a number for each of two directions, which must not differ
        if (member.size() == 2 && member.front().second.empty() && member.back().second.empty())
        {
            const double first = ValueOf(name, member.front().second), second = ValueOf(name, member.back().second);
            if (first == second)
                return first;
        }
        if (!member.empty())
            throw PrescriptionError(line, "\"" + std::string(name) + "\" with several values: a zoom, a surface that is not round or an "
                                          "index for each wavelength. One number is allowed.");
        return ValueOf(name, member);
    }

    double NumberOr(const char* name, double value) const { return Has(name) ? Number(name) : value; }

    /// Of a list, or of lists in a list, one after the other.
    std::vector<double> Numbers(const char* name) const
    {
        std::vector<double> numbers;
        if (Has(name))
            Collect(name, tree.find(name)->second, numbers);
        return numbers;
    }

  private:
    const Tree& tree;
    const int line;

    void Collect(const char* name, const Tree& list, std::vector<double>& numbers) const
    {
        for (const auto& [none, element] : list)
        {
            if (element.empty())
                numbers.push_back(ValueOf(name, element));
            else
                Collect(name, element, numbers);
        }
    }

    double ValueOf(const char* name, const Tree& value) const
    {
        const std::string& text = value.data();
        double number = 0.0;
        const std::from_chars_result read = std::from_chars(text.data(), text.data() + text.size(), number);
        if (text.empty() || read.ec != std::errc() || read.ptr != text.data() + text.size())
            throw PrescriptionError(line, "\"" + std::string(name) + "\" is '" + text.substr(0, 40) + "'. It must be a number.");
        return number;
    }
};

/// What no sphere is, by either form's member.
void ReadShape(const Members& surface, PrescriptionRow& row)
{
    row.conic = surface.NumberOr("conic_constant", 0.0);
    row.aspheric = surface.Numbers("aspherical-equation");
}

/// One number, or with `states` focuses one for each of them.
void ReadThickness(const Members& surface, std::size_t states, int line, PrescriptionRow& row)
{
    const std::vector<double> values = surface.Numbers("thickness");
    if (values.empty() || states == 0)
    {
        row.thickness = surface.Number("thickness");
        return;
    }
    if (values.size() != states)
        throw PrescriptionError(line, "\"thickness\" with " + std::to_string(values.size()) + " values, where \"object-distance\" has " +
                                      std::to_string(states) + ". Give one for each, or one number for a distance that stays.");
    row.thickness = values.front();
    row.nearThickness.assign(values.begin() + 1, values.end());
}

ReadRow LentilRow(const Members& element, int line, std::size_t states)
{
    ReadRow read;
    read.line = line;
    const std::string geometry = element.Text("lens-geometry"), material = element.Text("material");
    if (geometry.compare(0, 3, "cyl") == 0)
        throw PrescriptionError(line, "a cylindrical surface (\"lens-geometry\": \"" + geometry + "\"). Surfaces must be round about the "
                                      "axis; take another lens.");
    const double radius = element.Number("radius");
    read.row.radius = std::abs(radius) >= kPlaneRadius ? 0.0 : radius;
    ReadThickness(element, states, line, read.row);
    read.row.diameter = 2.0 * element.Number("housing-radius");
    ReadShape(element, read.row);
    read.stop = material == "iris";
    if (!read.stop && material != "air")
    {
        read.row.index = element.Number("ior");
        read.row.abbe = element.NumberOr("abbe", 0.0);
    }
    return read;
}

ReadRow IsetRow(const Members& surface, int line, std::size_t states)
{
    ReadRow read;
    read.line = line;
    read.row.radius = surface.Number("radius");
    ReadThickness(surface, states, line, read.row);
    read.row.diameter = 2.0 * surface.Number("semi_aperture");
    ReadShape(surface, read.row);
    if (surface.Has("transform"))
    {
        const std::vector<double> identity = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};  // four columns of three
        if (surface.Numbers("transform") != identity)
            throw PrescriptionError(line, "a surface with a \"transform\". Surfaces must be round about the axis; take another lens.");
    }
    read.row.index = surface.Number("ior");
    read.row.abbe = surface.NumberOr("abbe", 0.0);
    read.stop = read.row.radius == 0.0 && read.row.index == 0.0;
    return read;
}

/// The distances at which the file states where groups stand: infinity, which is left out, and nearer ones.
std::vector<double> ObjectDistancesOf(const Tree& lens, int line)
{
    const char* const name = "object-distance";
    const Members members(lens, line);
    if (!members.Has(name))
        return {};
    const Tree& list = lens.find(name)->second;
    const std::string first = list.empty() ? list.data() : list.front().second.data();
    if (first != "infinity" && first != "Infinity")
        throw PrescriptionError(line, "\"object-distance\" that begins with '" + first.substr(0, 40) + "'. It must be a list that begins with "
                                      "\"infinity\", as in [\"infinity\", 450], for which the first of each thickness holds.");
    Tree nearer;
    nearer.add_child(name, list);
    nearer.front().second.pop_front();
    std::vector<double> distances = Members(nearer, line).Numbers(name);
    if (distances.empty())
        throw PrescriptionError(line, "\"object-distance\" with infinity alone. Give a nearer distance behind it, in mm from the first surface, "
                                      "or leave it out.");
    for (std::size_t i = 0; i < distances.size(); i++)
        if (!(distances[i] > 0.0) || (i > 0 && !(distances[i] < distances[i - 1])))
            throw PrescriptionError(line, "an object distance of " + Number(distances[i]) + ". It must be larger than 0 and smaller than the one "
                                          "before it; give the thicknesses in the same order.");
    return distances;
}

template <typename RowOf>
ReadLens LensOf(const Tree& lens, const std::string& text, std::size_t from, const char* name, const RowOf& rowOf)
{
    const std::size_t stated = text.find("\"object-distance\"", from);
    const auto begin = text.begin(), end = stated == std::string::npos ? begin : begin + std::ptrdiff_t(stated);
    ReadLens read;
    read.objectDistanceLine = 1 + int(std::count(begin, end, '\n'));
    read.objectDistances = ObjectDistancesOf(lens, read.objectDistanceLine);
    const std::size_t states = read.objectDistances.empty() ? 0 : 1 + read.objectDistances.size();
    const ListLines lines(text, from, name);
    for (const auto& [none, element] : lens.find(name)->second)
    {
        const int line = lines.Of(read.rows.size());
        read.rows.push_back(rowOf(Members(element, line), line, states));
    }
    return read;
}

const char* LentilList(const Tree& lens)
{
    for (const char* name : {"optical-elements-patent", "optical-elements-adjusted"})
    {
        const auto found = lens.find(name);
        if (found != lens.not_found() && !found->second.empty())
            return name;
    }
    return nullptr;
}

/// The names of a database's lenses.
std::string Names(const Tree& database)
{
    std::string names;
    for (const auto& [name, lens] : database)
        if (LentilList(lens) != nullptr)
            names += (names.empty() ? "" : ", ") + name;
    return names;
}

} // namespace

ReadLens ReadJsonRows(const std::string& text, const std::string& choice)
{
    Tree file;
    std::istringstream stream(text);
    try
    {
        boost::property_tree::read_json(stream, file);
    }
    catch (const boost::property_tree::json_parser_error& error)
    {
        throw PrescriptionError(int(error.line()), "no JSON: " + error.message() + ". Mend the file, or take another.");
    }
    const std::string names = Names(file);
    if (choice.empty() && names.find(',') != std::string::npos)
        throw PrescriptionError(0, "several lenses. Choose one by its name behind the file's, as in \"FILE#" +
                                   names.substr(0, names.find(',')) + "\"; there are " + names + ".");
    if (!choice.empty() && (", " + names + ",").find(", " + choice + ",") == std::string::npos)
        throw PrescriptionError(0, "no lens of the name '" + choice + "'. " +
                                   (names.empty() ? "The file holds one lens; remove the '#' and what follows." : "There are " + names + "."));
    const std::string name = choice.empty() ? names : choice;
    const Tree& lens = name.empty() ? file : file.find(name)->second;
    const std::size_t from = name.empty() ? 0 : text.find('"' + name + '"');
    if (const char* list = LentilList(lens))
        return LensOf(lens, text, from, list, LentilRow);
    if (lens.find("surfaces") != lens.not_found())
        return LensOf(lens, text, from, "surfaces", IsetRow);
    throw PrescriptionError(0, "JSON of no known form. " + std::string(kKnown));
}

} // namespace tilt_lens
