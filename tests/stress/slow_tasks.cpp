// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file slow_tasks.cpp
/// Imitates a busy machine: sleeps at the start, after queueing a task and before every second thread's tile. Prints how many lights the
/// bounding task has copied.

#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include <boost/function.hpp>
#include <boost/thread.hpp>

#include "backend/frame.h"
#include "backend/bounding/boundingtask.h"
#include "backend/control/renderbackend.h"
#include "backend/scene/threaddata.h"
#include "backend/support/taskqueue.h"

// The linker (--wrap) redirects these functions.
boost::thread* Start(const boost::function0<void>& closed, void** address) __asm__("__wrap__Z11povray_initRKN5boost9function0IvEEPPv");
boost::thread* RealStart(const boost::function0<void>& closed, void** address) __asm__("__real__Z11povray_initRKN5boost9function0IvEEPPv");
pov::Task::TaskData* Append(pov::TaskQueue* queue, pov::Task* task) __asm__("__wrap__ZN3pov9TaskQueue10AppendTaskEPNS_4TaskE");
pov::Task::TaskData* RealAppend(pov::TaskQueue* queue, pov::Task* task) __asm__("__real__ZN3pov9TaskQueue10AppendTaskEPNS_4TaskE");
void Send(int view, void* address, unsigned int what,
          POVMS_Object& object) __asm__("__wrap__ZN3pov13RenderBackend14SendViewOutputEiPvjR12POVMS_Object");
void RealSend(int view, void* address, unsigned int what,
              POVMS_Object& object) __asm__("__real__ZN3pov13RenderBackend14SendViewOutputEiPvjR12POVMS_Object");

boost::thread* Start(const boost::function0<void>& closed, void** address)
{
    std::this_thread::sleep_for(std::chrono::seconds(4));
    return RealStart(closed, address);
}

pov::Task::TaskData* Append(pov::TaskQueue* queue, pov::Task* task)
{
    if (dynamic_cast<pov::BoundingTask*>(task) != nullptr)
        std::fprintf(stderr, "Bounding has copied %zu light sources\n",
                     dynamic_cast<pov::SceneThreadData&>(*task->GetDataPtr()).lightSources.size());
    pov::Task::TaskData* const data = RealAppend(queue, task);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    return data;
}

void Send(int view, void* address, unsigned int what, POVMS_Object& object)
{
    static std::atomic<unsigned int> count(0);
    if (what == kPOVMsgIdent_Progress && count++ % 2 == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    RealSend(view, address, what, object);
}
