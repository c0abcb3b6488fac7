// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file picture_layers.cpp
/// The renderer's part of `Output_Layers`: first hits along the rays through pixels' centres, effort of a finished tile, and the camera's
/// numbers. See base/picture_layers.h.

#include "base/picture_layers.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/math/vector.h"
#include "backend/render/tilt_lens_tracer.h"
#include "backend/render/tracepixel.h"
#include "backend/render/tracetask.h"
#include "backend/scene/layer_attributes.h"
#include "backend/scene/view.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

namespace
{

/// The layers of a tile, one after the other.
class LayerBlock
{
  public:
    explicit LayerBlock(size_t itsArea) : area(itsArea) {}

    /// Adds a layer of zeros.
    /// @return  its index
    size_t Add(const char* name)
    {
        names.push_back(name);
        values.resize(values.size() + area, 0.0f);
        return names.size() - 1;
    }

    POVMSFloat& At(size_t layer, size_t pixel) { return values[layer * area + pixel]; }

    void PutInto(POVMS_Message& message)
    {
        POVMS_Attribute numbers(values);
        message.SetString(kPOVAttrib_LayerNames, pov_base::JoinedNames(names).c_str());
        message.Set(kPOVAttrib_LayerValues, numbers);
    }

  private:
    const size_t area;
    std::vector<std::string> names;
    std::vector<POVMSFloat> values;
};

} // namespace

bool TiltLensTracer::FirstPoint(TracePixel& trace, unsigned int x, unsigned int y, DBL width, DBL height, Vec3& point,
                                DBL& depth)
{
    // POV-Ray's own focal blur must not jitter the ray
    const bool blurs = trace.useFocalBlur;
    trace.useFocalBlur = false;
    Ray ray;
    const bool seen = ChiefCameraRay(trace, ray, x, y, width, height);
    trace.useFocalBlur = blurs;
    const DBL distance = seen ? FirstHit(trace, ray) : HUGE_VAL;
    if (!(distance < HUGE_VAL))
        return false;
    point = FromPov(ray.Origin) + distance * FromPov(ray.Direction);
    depth = distance;
    if (HasDepthAxis(trace.camera))
        depth = Dot(point - FromPov(trace.camera.Location), DepthAxis(trace.camera));
    return true;
}

/// Called for each tile before its colours are sent, so that a tile whose colours are in the state file has its layers there, too.
void TraceTask::SendLayers(const POVRect& rect)
{
    const ViewData& view = *GetViewData();
    if (!finalTrace || !view.OutputsLayers())
        return;
    const TiltLensTracer* tracer = TiltLensTracer::Of(trace);
    const float infinity = std::numeric_limits<float>::infinity();
    const DBL width = view.GetWidth(), height = view.GetHeight();
    LayerBlock block(rect.GetArea());
    const size_t depthLayer = block.Add("depth.Z");
    const size_t positions[3] = {block.Add("position.X"), block.Add("position.Y"), block.Add("position.Z")};
    const size_t blur = view.GetCamera().TiltLens.given ? block.Add("blur") : 0;
    const bool sampled = tracer != NULL && !tracer->Effort().empty();
    const size_t samples = sampled ? block.Add("samples") : 0, error = sampled ? block.Add("standardError") : 0;

    size_t pixel = 0;
    for (unsigned int y = rect.top; y <= rect.bottom; y++)
        for (unsigned int x = rect.left; x <= rect.right; x++, pixel++)
        {
            Vec3 point;
            DBL depth = HUGE_VAL;
            const bool found = TiltLensTracer::FirstPoint(trace, x, y, width, height, point, depth);
            block.At(depthLayer, pixel) = found ? float(depth) : infinity;
            block.At(positions[0], pixel) = point.x;
            block.At(positions[1], pixel) = point.y;
            block.At(positions[2], pixel) = point.z;
            if (tracer != NULL)
                block.At(blur, pixel) = view.GetTiltLens()->camera->Blur(tilt_lens::FilmPointAt(x + 0.5, y + 0.5, width, height),
                                                                         found ? depth : double(infinity), width);
            if (sampled)
            {
                block.At(samples, pixel) = tracer->Effort()[pixel].samples;
                block.At(error, pixel) = std::sqrt(tracer->Effort()[pixel].variance);
            }
        }

    POVMS_Message message(kPOVObjectClass_PixelData, kPOVMsgClass_ViewImage, pov_base::kPOVMsgIdent_Layers);
    message.SetInt(kPOVAttrib_Left, rect.left);
    message.SetInt(kPOVAttrib_Top, rect.top);
    message.SetInt(kPOVAttrib_Right, rect.right);
    message.SetInt(kPOVAttrib_Bottom, rect.bottom);
    block.PutInto(message);
    view.Post(message);
}

void ViewData::Post(POVMS_Message& message) const
{
    message.SetInt(kPOVAttrib_ViewId, viewId);
    message.SetSourceAddress(sceneData->backendAddress);
    message.SetDestinationAddress(sceneData->frontendAddress);
    POVMS_SendMessage(message);
}

/// Sends the camera's numbers to the front end, if layers are asked for.
void View::StartLayers(POVMS_Object& options)
{
    viewData.outputLayers = options.TryGetBool(pov_base::kPOVAttrib_OutputLayers, false);
    if (!viewData.outputLayers)
        return;
    std::vector<std::string> names;
    std::vector<POVMSInt> sizes;
    std::vector<POVMSFloat> values;
    for (const LayerAttribute& attribute : LayerAttributesOf(viewData.camera, viewData.width))
    {
        names.push_back(attribute.name);
        sizes.push_back(attribute.values.size());
        values.insert(values.end(), attribute.values.begin(), attribute.values.end());
    }
    if (names.empty())
        return;
    POVMS_Message message(kPOVObjectClass_PixelData, kPOVMsgClass_ViewImage, pov_base::kPOVMsgIdent_LayerAttributes);
    POVMS_Attribute numbers(values);
    message.SetString(pov_base::kPOVAttrib_LayerNames, pov_base::JoinedNames(names).c_str());
    message.SetIntVector(pov_base::kPOVAttrib_LayerSizes, sizes);
    message.Set(pov_base::kPOVAttrib_LayerValues, numbers);
    viewData.Post(message);
}

} // namespace pov
