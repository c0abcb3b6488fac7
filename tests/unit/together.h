// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_TESTS_TOGETHER_H
#define TILT_LENS_TESTS_TOGETHER_H

#include <future>
#include <stdexcept>
#include <vector>

namespace tilt_lens
{

/// Calls `work` in each of several threads, and waits for all.
template<class Work>
void RunTogether(int threads, const Work& work)
{
    std::vector<std::future<void>> running;
    for (int i = 0; i < threads; i++)
        running.push_back(std::async(std::launch::async, work));
    for (std::future<void>& one : running)
        one.get();
}

/// Threads take the tasks that `next` gives, until there are none. Interrupted tasks are asked for again.
template<class Next, class Take>
void TakeTogether(int threads, const Next& next, const Take& take)
{
    RunTogether(threads, [&]
    {
        while (const auto task = next())
            try
            {
                take(*task);
            }
            catch (const std::runtime_error&)
            {
            }
    });
}

} // namespace tilt_lens

#endif
