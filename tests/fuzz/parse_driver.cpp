// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "parse_driver.h"

#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <type_traits>

#include <boost/format.hpp>

#include "backend/frame.h"
#include "backend/parser/parse.h"
#include "backend/scene/camera.h"
#include "backend/scene/scene.h"
#include "base/povms.h"
#include "frontend/shelloutprocessing.h"
#include "tilt_lens/camera/ray.h"

namespace
{

// deleted through this base, which sanitizers report
static_assert(std::has_virtual_destructor<pov_frontend::ShelloutProcessing>::value);

// once set, makes a thread destroy data of the task's thread
static_assert(std::is_same<decltype(pov::Task::done), std::atomic<bool>>::value);

ParseOutcome* current = nullptr;
int sceneFile = -1;

void Catch(POVMSObjectPtr message)
{
    POVMSType kind = 0;
    (void)POVMSMsg_GetMessageIdentifier(message, &kind);
    int length = 0;
    if (current == nullptr || POVMSUtil_GetStringLength(message, kPOVAttrib_EnglishText, &length) != 0)
        return;
    std::string text(std::size_t(length), '\0');
    (void)POVMSUtil_GetString(message, kPOVAttrib_EnglishText, &text[0], &length);
    text.resize(text.find('\0'));
    if (kind == kPOVMsgIdent_FatalError)
        current->errors.push_back(text);
    else if (kind == kPOVMsgIdent_Warning)
        current->warnings.push_back(text);
}

class Finish
{
  public:
    void Signal()
    {
        const std::lock_guard<std::mutex> lock(mutex);
        done = true;
        changed.notify_all();
    }
    void Wait()
    {
        std::unique_lock<std::mutex> lock(mutex);
        changed.wait(lock, [this] { return done; });
    }

  private:
    std::mutex mutex;
    std::condition_variable changed;
    bool done = false;
};

std::string BrokenRay(const tilt_lens::Lens& lens)
{
    for (double x : {-0.5, 0.0, 0.5})
        for (double y : {-0.5, 0.0, 0.5})
            for (double a : {-0.7, 0.0, 0.7})
                for (double b : {-0.7, 0.0, 0.7})
                {
                    const tilt_lens::LensRay ray = MakeRay(lens, x, y, a, b);
                    const double length = Length(ray.direction);
                    if (!IsFinite(ray.origin) || !(length > 0.0) || !IsFinite(ray.direction / length))
                        return "an accepted lens makes a ray without numbers";
                }
    return "";
}

} // namespace

// --wrap redirects these functions
int Send(POVMSContext, POVMSObjectPtr message, POVMSObjectPtr, int) __asm__("__wrap__Z10POVMS_SendPvP9POVMSDataS1_i");
pov_base::UCS2String FindFile(pov::SceneData*, POVMSContext, const pov_base::UCS2String&, unsigned int) __asm__(
    "__wrap__ZN3pov9SceneData8FindFileEPvRKNSt7__cxx1112basic_stringItSt11char_traitsItESaItEEEj");
pov_base::IStream* ReadFile(pov::SceneData*, POVMSContext, const pov_base::UCS2String&, const pov_base::UCS2String&, unsigned int) __asm__(
    "__wrap__ZN3pov9SceneData8ReadFileEPvRKNSt7__cxx1112basic_stringItSt11char_traitsItESaItEEES9_j");
pov_base::OStream* CreateFile(pov::SceneData*, POVMSContext, const pov_base::UCS2String&, unsigned int, bool) __asm__(
    "__wrap__ZN3pov9SceneData10CreateFileEPvRKNSt7__cxx1112basic_stringItSt11char_traitsItESaItEEEjb");

int Send(POVMSContext, POVMSObjectPtr message, POVMSObjectPtr, int)
{
    Catch(message);
    (void)POVMSObject_Delete(message);
    return 0;
}

pov_base::UCS2String FindFile(pov::SceneData*, POVMSContext, const pov_base::UCS2String& name, unsigned int kind)
{
    return kind == pov_base::POV_File_Text_POV ? name : pov_base::UCS2String();
}

pov_base::IStream* ReadFile(pov::SceneData*, POVMSContext, const pov_base::UCS2String&, const pov_base::UCS2String&, unsigned int kind)
{
    const std::string path = "/proc/self/fd/" + std::to_string(sceneFile);
    pov_base::IStream* stream = new pov_base::IStream(kind);
    if (!stream->open(pov_base::ASCIItoUCS2String(path.c_str()), 0))
        std::abort();
    return stream;
}

pov_base::OStream* CreateFile(pov::SceneData*, POVMSContext, const pov_base::UCS2String&, unsigned int, bool)
{
    return nullptr;
}

ParseOutcome Parse(const std::string& scene)
{
    ParseOutcome outcome;
    current = &outcome;
    sceneFile = memfd_create("scene.pov", 0);
    if (sceneFile < 0 || write(sceneFile, scene.data(), scene.size()) != ssize_t(scene.size()))
        std::abort();
    {
        shared_ptr<pov::SceneData> data(new pov::SceneData);
        // upstream's Scene sets it from the command line
        data->inputFile = pov_base::ASCIItoUCS2String("scene.pov");
        data->realTimeRaytracing = data->clocklessAnimation = data->outputAlpha = false;
        data->boundingMethod = 1;
        data->defaultFileType = kPOVList_FileType_PNG;
        pov::Parser parser(data, false, 0.0);
        pov::SceneThreadData* own = dynamic_cast<pov::SceneThreadData*>(parser.GetDataPtr());
        Finish finish;
        parser.Start([&finish] { finish.Signal(); });
        finish.Wait();
        parser.Stop();
        const pov::Camera& camera = data->parsedCamera;
        // rays find such a focus when the render begins
        if (outcome.errors.empty() && camera.TiltLens.given && camera.TiltLens.IsComplete())
        {
            outcome.lens = true;
            outcome.broken = BrokenRay(*camera.TiltLens.lens);
        }
        delete own;
    }
    close(sceneFile);
    current = nullptr;
    return outcome;
}

std::string SceneAround(const std::string& block)
{
    return "#version 3.7; global_settings { assumed_gamma 1 }\n"
           "camera { location <0.4, 1.5, -4> look_at <0, 0.5, 0.5> angle 45 aperture 0.3\ntilt_lens {" +
           block + "} }\nsphere { 0, 1 }\n";
}

std::string Complaint(const ParseOutcome& outcome)
{
    if (outcome.errors.size() > 1)
        return "more than one error: " + outcome.errors[0] + " | " + outcome.errors[1];
    if (!outcome.errors.empty() && outcome.errors[0].size() < sizeof "Parse Error: ")
        return "an error without words";
    return outcome.broken;
}
