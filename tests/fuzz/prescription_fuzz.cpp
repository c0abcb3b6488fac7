// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file prescription_fuzz.cpp
/// libFuzzer's target for prescriptions, which give a lens that can be focused, or an error that names a line.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/glass/prescription.h"

namespace
{

[[noreturn]] void Fail(const char* what)
{
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    try
    {
        const tilt_lens::Prescription prescription = tilt_lens::ReadPrescription(text);
        (void)tilt_lens::GlassLens(tilt_lens::Scaled(prescription, 2.0)).Cardinal();
    }
    catch (const tilt_lens::PrescriptionError& error)
    {
        const int lines = 1 + int(std::count(text.begin(), text.end(), '\n'));
        if (error.line < 0 || error.line > lines)
            Fail("an error in a line that is not there");
        const std::string words = error.what();
        if (words.size() < 20)
            Fail("an error without words");
    }
    return 0;
}
