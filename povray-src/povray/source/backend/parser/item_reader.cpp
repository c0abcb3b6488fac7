// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/parser/item_reader.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

namespace
{

std::string Text(const char* format, va_list values)
{
    va_list again;
    va_copy(again, values);
    std::string text(std::vsnprintf(NULL, 0, format, again), ' ');
    va_end(again);
    std::vsnprintf(text.data(), text.size() + 1, format, values);
    return text;
}

} // namespace

std::string Printed(const char* format, ...)
{
    va_list values;
    va_start(values, format);
    const std::string text = Text(format, values);
    va_end(values);
    return text;
}

void Refuse(const char* format, ...)
{
    va_list values;
    va_start(values, format);
    const std::string text = Text(format, values);
    va_end(values);
    throw tilt_lens::OpticsError(text);
}

void ItemReader::Read(TiltLensCamera& lens)
{
    if (item.family)
        lens.statement.family = *item.family;
    if (item.read != NULL)
        item.read(*this, lens);
    for (const ItemNumber& number : item.numbers)
    {
        if (&number != &item.numbers.front() && !NextIsComma())
            return;
        number.set(lens, Number(number.name == NULL ? item.word : number.name, number.range));
    }
}

/// Refuses tokens that begin no value, so that the error names the item.
int ItemReader::Numbers(const std::string& name, EXPRESS values)
{
    parser.Get_Token();
    const int token = parser.Token.Token_Id;
    const std::string text = parser.Token.Token_String;
    parser.Unget_Token();
    if (token == END_OF_FILE_TOKEN || token == IDENTIFIER_TOKEN || token == STRING_LITERAL_TOKEN || token == RIGHT_CURLY_TOKEN ||
        token == LEFT_CURLY_TOKEN || token == COMMA_TOKEN || token == SEMI_COLON_TOKEN)
    {
        const bool undeclared = token == IDENTIFIER_TOKEN && FindTiltLensItem(text) == NULL;
        const std::string found = token == END_OF_FILE_TOKEN ? "the end of the file" : (undeclared ? "the undeclared '" : "'") + text + "'";
        Refuse("%s in tilt_lens has no value: found %s in its place. Write it as %s, with a number, a vector or an expression of them.",
               name.c_str(), found.c_str(), item.Example().c_str());
    }
    return parser.Parse_Unknown_Vector(values);
}

double ItemReader::Number(const std::string& name, const NumberRange& range)
{
    EXPRESS values;
    const int terms = Numbers(name, values);
    if (terms != 1)
        Refuse("%s in tilt_lens: found a value of %d numbers. It takes one number; write one, or a component such as .x of a vector.",
               name.c_str(), terms);
    const double value = values[0];
    if (!std::isfinite(value))
        Refuse("%s %g in tilt_lens. It must be a finite number; check the expression.", name.c_str(), value);
    if (value < range.least || value > range.most || (range.whole && value != std::floor(value)))
        Refuse("%s %.*g in tilt_lens. %s", name.c_str(), range.whole && range.most > 1e6 ? 12 : 6, value, range.message.c_str());
    return value;
}

Vec3 ItemReader::Vector()
{
    EXPRESS v;
    const int terms = Numbers(item.word, v);
    if (terms != 3)
        Refuse("%s in tilt_lens: found a value of %d numbers. A point or normal has three; write it as <x, y, z>.", item.word, terms);
    const Vec3 value{v[X], v[Y], v[Z]};
    if (!IsFinite(value))
        Refuse("%s in tilt_lens: found <%g, %g, %g>. All three numbers must be finite; check the expression.", item.word, v[X], v[Y], v[Z]);
    return value;
}

bool ItemReader::NextIsComma()
{
    parser.Get_Token();
    const bool comma = parser.Token.Token_Id == COMMA_TOKEN;
    if (!comma)
        parser.Unget_Token();
    return comma;
}

} // namespace pov
