// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// configbase.h must come first in the front end's files
#include "base/configbase.h"

#include "frontend/option_ranges.h"

#include <cmath>
#include <cstdio>

#include "base/povms.h"
#include "base/povmsgid.h"
#include "frontend/configfrontend.h"

#include "base/povdebug.h"

namespace pov_frontend
{

using namespace pov_base;

namespace
{

std::string Text(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

/// Checks a count against its least value.
std::string CountProblem(POVMS_Object& options, POVMSType key, int usual, const char* name, const char* letters, int least = 1)
{
    const int value = options.TryGetInt(key, usual);
    if (value >= least)
        return std::string();
    return std::string(name) + "=" + std::to_string(value) + " (" + letters + std::to_string(value) +
           "). A whole number of at least " + std::to_string(least) + " is allowed; give another value.";
}

std::string GammaProblem(POVMS_Object& options, POVMSType typeKey, POVMSType key, const char* name)
{
    const double value = options.TryGetFloat(key, 1.0f);
    if (options.TryGetInt(typeKey, kPOVList_GammaType_SRGB) != kPOVList_GammaType_PowerLaw || value >= 0.001)
        return std::string();
    return std::string(name) + "=" + Text(value) + ". A number of at least 0.001, or sRGB, is allowed; give another value.";
}

std::string FrameProblem(POVMS_Object& options)
{
    if (!options.Exist(kPOVAttrib_InitialFrame) || !options.Exist(kPOVAttrib_FinalFrame))
        return std::string();
    const int first = options.GetInt(kPOVAttrib_InitialFrame), last = options.GetInt(kPOVAttrib_FinalFrame);
    if (first <= last)
        return std::string();
    return "Initial_Frame=" + std::to_string(first) + " (+KFI) and Final_Frame=" + std::to_string(last) + " (+KFF): the last frame lies before "
           "the first. Give a last frame of at least the first.";
}

struct Span
{
    POVMSType firstKey, lastKey;
    const char *firstName, *lastName, *many;
};

/// Checks columns or rows of a partial render, read as in View::StartRender(): numbers below 1 are fractions of the picture, others count
/// from 1.
std::string SpanProblem(POVMS_Object& options, const Span& span, int size)
{
    const double first = options.TryGetFloat(span.firstKey, 1.0f);
    const double last = options.TryGetFloat(span.lastKey, POVMSFloat(size));
    const double begin = first >= 0.0 && first < 1.0 ? std::floor(size * first) + 1.0 : std::floor(first);
    const double end = last >= 0.0 && last <= 1.0 ? std::floor(size * last) : std::floor(last);
    if (begin >= 1.0 && begin <= end && end <= size)
        return std::string();
    return std::string(span.firstName) + "=" + Text(first) + " and " + span.lastName + "=" + Text(last) + " mean " + span.many +
           " " + Text(begin) + " to " + Text(end) + " of " + std::to_string(size) + ". They must not go beyond the picture, "
           "nor may the end lie before the start; whole numbers count from 1, numbers below 1 are shares of the picture.";
}

} // namespace

std::string RangeProblem(POVMS_Object& options)
{
    std::string problem = CountProblem(options, kPOVAttrib_Width, 160, "Width", "+W");
    if (problem.empty())
        problem = CountProblem(options, kPOVAttrib_Height, 120, "Height", "+H");
    if (problem.empty())
        problem = CountProblem(options, kPOVAttrib_MaxRenderThreads, 1, "Work_Threads", "+WT");
    if (problem.empty())
        problem = SpanProblem(options, {kPOVAttrib_Left, kPOVAttrib_Right, "Start_Column", "End_Column", "columns"},
                              options.TryGetInt(kPOVAttrib_Width, 160));
    if (problem.empty())
        problem = SpanProblem(options, {kPOVAttrib_Top, kPOVAttrib_Bottom, "Start_Row", "End_Row", "rows"},
                              options.TryGetInt(kPOVAttrib_Height, 120));
    if (problem.empty())
        problem = CountProblem(options, kPOVAttrib_RenderBlockSize, 32, "Render_Block_Size", "+BS", 4);
    if (problem.empty())
        problem = GammaProblem(options, kPOVAttrib_FileGammaType, kPOVAttrib_FileGamma, "File_Gamma");
    if (problem.empty())
        problem = GammaProblem(options, kPOVAttrib_DisplayGammaType, kPOVAttrib_DisplayGamma, "Display_Gamma");
    if (problem.empty())
        problem = FrameProblem(options);
    return problem;
}

} // namespace pov_frontend
