// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <cmath>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/glass/json_value.h"
#include "tilt_lens/glass/prescription_rows.h"

namespace tilt_lens
{

namespace
{

using Kind = JsonValue::Kind;

/// Larger radii (mm) are planes.
constexpr double kPlaneRadius = 99999.0;

/// Known lenses have up to eight and five.
constexpr std::size_t kMostCoefficients = 20, kMostFocuses = 20;

const char* const kKnown = "Known are lentil's form, with \"optical-elements-patent\", and that of ISET, with \"surfaces\".";

class Members
{
  public:
    explicit Members(const JsonValue& itsObject) : object(itsObject) {}

    bool Has(const char* name) const { return object.Find(name) != nullptr; }

    std::string Text(const char* name) const
    {
        const JsonValue* const found = object.Find(name);
        if (found != nullptr && !found->Is(Kind::kText))
            throw Wrong(name, *found, "a text");
        return found != nullptr ? found->text : std::string();
    }

    double Number(const char* name) const
    {
        const JsonValue* const found = object.Find(name);
        if (found == nullptr)
            throw PrescriptionError(object.line, "a surface without \"" + std::string(name) + "\", which must be a number.");
        if (!found->Is(Kind::kList))
            return ValueOf(name, *found);
        // one value per meridian, all equal
        const std::vector<JsonValue>& values = found->members;
        if (values.size() == 2 && values[0].Is(Kind::kNumber) && values[1].Is(Kind::kNumber) && values[0].number == values[1].number)
            return values[0].number;
        throw PrescriptionError(found->line, "\"" + std::string(name) +
                                                 "\" with several values: a zoom, a surface that is not round or "
                                                 "an index for each wavelength. One number is allowed.");
    }

    double NumberOr(const char* name, double value) const { return Has(name) ? Number(name) : value; }

    /// Flattens nested lists.
    std::vector<double> Numbers(const char* name, std::size_t most) const
    {
        std::vector<double> numbers;
        const JsonValue* const found = object.Find(name);
        if (found != nullptr && !found->Is(Kind::kList))
            throw Wrong(name, *found, "a list of numbers");
        if (found != nullptr)
            Collect(name, *found, numbers);
        if (numbers.size() > most)
            throw PrescriptionError(found->line, "\"" + std::string(name) + "\" with " + std::to_string(numbers.size()) +
                                                     " numbers. At most " + std::to_string(most) + " are allowed.");
        return numbers;
    }

    bool HasList(const char* name) const { return Has(name) && object.Find(name)->Is(Kind::kList); }

  private:
    const JsonValue& object;

    static PrescriptionError Wrong(const char* name, const JsonValue& value, const char* allowed)
    {
        return PrescriptionError(value.line, "\"" + std::string(name) + "\" is " + value.Words() + ". It must be " + allowed + ".");
    }

    static void Collect(const char* name, const JsonValue& list, std::vector<double>& numbers)
    {
        for (const JsonValue& element : list.members)
        {
            if (element.Is(Kind::kList))
                Collect(name, element, numbers);
            else
                numbers.push_back(ValueOf(name, element));
        }
    }

    static double ValueOf(const char* name, const JsonValue& value)
    {
        if (!value.Is(Kind::kNumber))
            throw Wrong(name, value, "a number");
        return value.number;
    }
};

void ReadShape(const Members& surface, PrescriptionRow& row)
{
    row.conic = surface.NumberOr("conic_constant", 0.0);
    row.aspheric = surface.Numbers("aspherical-equation", kMostCoefficients);
}

/// One number, or one for each of `states` focuses.
void ReadThickness(const Members& surface, std::size_t states, int line, PrescriptionRow& row)
{
    if (states == 0 || !surface.HasList("thickness"))
    {
        row.thickness = surface.Number("thickness");
        return;
    }
    const std::vector<double> values = surface.Numbers("thickness", kMostFocuses + 1);
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
        throw PrescriptionError(line, "a cylindrical surface (\"lens-geometry\": \"" + Shown(geometry) +
                                          "\"). Surfaces must be round about the "
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
        if (surface.Numbers("transform", identity.size()) != identity)
            throw PrescriptionError(line, "a surface with a \"transform\". Surfaces must be round about the axis; take another lens.");
    }
    read.row.index = surface.Number("ior");
    read.row.abbe = surface.NumberOr("abbe", 0.0);
    read.stop = read.row.radius == 0.0 && read.row.index == 0.0;
    return read;
}

/// Without the leading infinity.
std::vector<double> ObjectDistancesOf(const JsonValue& stated)
{
    const bool list = stated.Is(Kind::kList) && !stated.members.empty();
    const JsonValue& first = list ? stated.members.front() : stated;
    if (!list || (first.text != "infinity" && first.text != "Infinity"))
        throw PrescriptionError(stated.line, "\"object-distance\" that begins with " + first.Words() +
                                                 ". It must be a list that begins with "
                                                 "\"infinity\", as in [\"infinity\", 450], for which the first of each thickness holds.");
    JsonValue nearer = stated, holder;
    nearer.members.erase(nearer.members.begin());
    holder.kind = Kind::kObject;
    holder.members.push_back(nearer);
    const std::vector<double> distances = Members(holder).Numbers("object-distance", kMostFocuses);
    if (distances.empty())
        throw PrescriptionError(stated.line,
                                "\"object-distance\" with infinity alone. Give a nearer distance behind it, in mm from the first "
                                "surface, or leave it out.");
    for (std::size_t i = 0; i < distances.size(); i++)
        if (!(distances[i] > 0.0) || (i > 0 && !(distances[i] < distances[i - 1])))
            throw PrescriptionError(stated.line, "an object distance of " + Number(distances[i]) +
                                                     ". It must be larger than 0 and smaller than the "
                                                     "one before it; give the thicknesses in the same order.");
    return distances;
}

template<typename RowOf>
ReadLens LensOf(const JsonValue& lens, const char* name, const RowOf& rowOf)
{
    ReadLens read;
    if (const JsonValue* const stated = lens.Find("object-distance"))
    {
        read.objectDistanceLine = stated->line;
        read.objectDistances = ObjectDistancesOf(*stated);
    }
    const std::size_t states = read.objectDistances.empty() ? 0 : 1 + read.objectDistances.size();
    const JsonValue& list = *lens.Find(name);
    if (!list.Is(Kind::kList))
        throw PrescriptionError(list.line, "\"" + std::string(name) + "\" is " + list.Words() + ". It must be a list of surfaces.");
    for (const JsonValue& element : list.members)
    {
        if (!element.Is(Kind::kObject))
            throw PrescriptionError(element.line, element.Words() + " in \"" + name + "\". Each surface must be an object.");
        read.rows.push_back(rowOf(Members(element), element.line, states));
    }
    return read;
}

const char* LentilList(const JsonValue& lens)
{
    for (const char* name : {"optical-elements-patent", "optical-elements-adjusted"})
    {
        const JsonValue* const found = lens.Find(name);
        if (found != nullptr && !(found->Is(Kind::kList) && found->members.empty()))
            return name;
    }
    return nullptr;
}

/// The chosen or only lens of a database, or the whole file.
const JsonValue& Chosen(const JsonValue& file, const std::string& choice)
{
    std::vector<const JsonValue*> lenses;
    std::string names;
    for (const JsonValue& member : file.members)
        if (LentilList(member) != nullptr)
        {
            if (!choice.empty() && member.name == choice)
                return member;
            lenses.push_back(&member);
            names += (names.empty() ? "" : ", ") + Shown(member.name);
        }
    if (!choice.empty())
        throw PrescriptionError(
            0, "no lens of the name '" + Shown(choice) + "'. " +
                   (names.empty() ? "The file holds one lens; remove the '#' and what follows." : "There are " + names + "."));
    if (lenses.size() > 1)
        throw PrescriptionError(0, "several lenses. Choose one by its name behind the file's, as in \"FILE#" + Shown(lenses[0]->name) +
                                       "\"; there are " + names + ".");
    return lenses.empty() ? file : *lenses[0];
}

} // namespace

ReadLens ReadJsonRows(const std::string& text, const std::string& choice)
{
    const JsonValue file = ReadJson(text);
    const JsonValue& lens = Chosen(file, choice);
    if (const char* list = LentilList(lens))
        return LensOf(lens, list, LentilRow);
    if (lens.Find("surfaces") != nullptr)
        return LensOf(lens, "surfaces", IsetRow);
    throw PrescriptionError(0, "JSON of no known form. " + std::string(kKnown));
}

} // namespace tilt_lens
