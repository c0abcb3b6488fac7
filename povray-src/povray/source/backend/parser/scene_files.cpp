// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// frame.h must always be the first POV file included (pulls in platform config)
#include "backend/frame.h"

#include "backend/parser/scene_files.h"

#include "backend/parser/parse.h"
#include "base/file_permissions.h"
#include "base/stringutilities.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

void RequirePermission(Parser &parser, const UCS2String &name, bool writing)
{
    const std::string problem = tilt_lens::FileProblem(UCS2toASCIIString(name), writing);
    if (!problem.empty())
        parser.Error("%s", problem.c_str());
}

void FinishFile(Parser &parser, pov_base::OTextStream *&file, bool closedByScene)
{
    try
    {
        file->flush();
    }
    catch (const pov_base::Exception &error)
    {
        delete file;
        file = NULL;
        if (closedByScene)
            parser.Error("%s Make room there, and render again.", error.what());
        parser.messageFactory.PossibleError("%s Make room there, and render again.", error.what());
    }
}

}
