// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file shared_tasks.h
/// Numbered tasks that several threads share, in rounds: none of the next round begins before all of this one have ended.

#ifndef TILT_LENS_SHARED_TASKS_H
#define TILT_LENS_SHARED_TASKS_H

#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

namespace tilt_lens
{

struct TaskProgress
{
    std::size_t round;  ///< the first is 1
    double share;  ///< of the round's tasks that have ended
};

/// Thread-safe, but for BeginRound().
class SharedTasks
{
  public:
    /// To be called before the first round's tasks are asked for, and from the `endRound` of Take().
    /// @param tasks  0: no more rounds
    void BeginRound(std::size_t tasks)
    {
        round += tasks > 0;
        count = tasks;
        given = ended = 0;
    }

    TaskProgress Progress() const
    {
        const std::lock_guard<std::mutex> lock(mutex);
        return {round, count == 0 ? 1.0 : double(ended) / count};
    }

    /// 0 to the round's count - 1. Waits while other threads take the last tasks of a round; none after the last round.
    std::optional<std::size_t> Next()
    {
        std::unique_lock<std::mutex> lock(mutex);
        changed.wait(lock, [this] { return count == 0 || !again.empty() || given < count; });
        if (count == 0)
            return {};
        if (again.empty())
            return given++;
        const std::size_t task = again.back();
        again.pop_back();
        return task;
    }

    /// If `work` throws, another thread gets the task.
    /// @param endRound  called by the thread that ends a round's last task, while no other works; begins the next round. If it throws,
    ///                  there are no more rounds
    template<class Work, class EndRound>
    void Take(std::size_t task, const Work& work, const EndRound& endRound)
    {
        try
        {
            work();
        }
        catch (...)
        {
            const std::lock_guard<std::mutex> lock(mutex);
            again.push_back(task);
            changed.notify_all();
            throw;
        }
        const std::lock_guard<std::mutex> lock(mutex);
        if (++ended < count)
            return;
        try
        {
            endRound();
        }
        catch (...)
        {
            count = 0;
            changed.notify_all();
            throw;
        }
        changed.notify_all();
    }

  private:
    mutable std::mutex mutex;
    std::condition_variable changed;
    std::size_t round = 0, count = 0, given = 0, ended = 0;
    std::vector<std::size_t> again;  ///< interrupted
};

}  // namespace tilt_lens

#endif
