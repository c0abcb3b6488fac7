// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file macro_arguments.cpp
/// Checks arguments of tilt_lens.inc's macros, since the scene language cannot ask for a value's type.

#include "backend/parser/parse_tilt_lens.h"

#include <cstring>

#include "backend/parser/item_reader.h"
#include "backend/parser/parse.h"

#include "base/povdebug.h"

namespace pov
{

namespace
{

/// Parameters not listed take numbers.
struct Parameter
{
    const char* name;
    const char* kind;
    const char* example;
};

const char kVector[] = "a point <x, y, z>", kPair[] = "a vector of two numbers", kArray[] = "an array", kText[] = "a text";

const Parameter kParameters[] = {{"Location", kVector, "<0, 1.6, -6>"},
                                 {"Look_At", kVector, "<0, 1, 0>"},
                                 {"Subject", kVector, "<0, 1, 0>"},
                                 {"Other", kVector, "<0, 1, 0>"},
                                 {"Near", kVector, "<0, 0, 2>"},
                                 {"Far", kVector, "<0, 0, 20>"},
                                 {"Lower_Left", kVector, "<-5, 0, 0>"},
                                 {"Lower_Right", kVector, "<5, 0, 0>"},
                                 {"Upper_Left", kVector, "<-5, 8, 0>"},
                                 {"Shift", kPair, "<0, 8>"},
                                 {"Film", kArray, "Tilt_Lens_Film_Full_Frame"},
                                 {"Lens", kArray, "Tilt_Lens_TS_24"},
                                 {"File", kText, "\"lenses/zeiss_planar_50.dat\""},
                                 {"Macro", kText, "\"Name\""},
                                 {"Name", kText, "\"Name\""}};

const Parameter kNumber = {"", "a number", "24"};

const Parameter& ParameterNamed(const char* name)
{
    for (const Parameter& parameter : kParameters)
        if (std::strcmp(parameter.name, name) == 0)
            return parameter;
    return kNumber;
}

const char* KindOf(int token)
{
    switch (token)
    {
        case FLOAT_ID_TOKEN: return kNumber.kind;
        case UV_ID_TOKEN: return kPair;
        case VECTOR_ID_TOKEN: return kVector;
        case VECTOR_4D_ID_TOKEN: return "a vector of four numbers";
        case COLOUR_ID_TOKEN: return "a colour";
        case ARRAY_ID_TOKEN: return kArray;
        case STRING_ID_TOKEN: return kText;
        case IDENTIFIER_TOKEN:
        case EMPTY_ARRAY_TOKEN: return "undeclared";
        default: return "of another kind";
    }
}

/// A number may stand for a point.
bool IsAllowed(const char* found, const char* wanted)
{
    return found == wanted || (wanted == kVector && found == kNumber.kind) || (wanted == kPair && found == kVector);
}

} // namespace

void TiltLensParser::CheckMacro(const char* macro, SYM_ENTRY* const* arguments, char* const* names, int count)
{
    if (std::strncmp(macro, "Tilt_Lens_", 10) != 0)
        return;
    for (int i = 0; i < count; i++)
    {
        const SYM_ENTRY& argument = *arguments[i];
        const bool byName = argument.Token_Number == PARAMETER_ID_TOKEN;
        const char* found = KindOf(byName ? *static_cast<Parser::POV_PARAM*>(argument.Data)->NumberPtr : argument.Token_Number);
        const Parameter& wanted = ParameterNamed(names[i]);
        if (!IsAllowed(found, wanted.kind))
            ErrorAt(Here(),
                    Printed("%s: %s is %s. It must be %s; write for example %s.", macro, names[i], found, wanted.kind, wanted.example));
    }
}

} // namespace pov
