# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Tasks that nobody waits for."""

import asyncio
import traceback


def print_fault(task):
    if not task.cancelled() and task.exception():
        traceback.print_exception(task.exception())


def started(coroutine):
    """Prints the exception that ends it."""
    task = asyncio.create_task(coroutine)
    task.add_done_callback(print_fault)
    return task


async def ended(task):
    """Waits for the end of a task, or of None, and ignores its outcome."""
    if task:
        await asyncio.wait([task])


async def stopped(task):
    """Cancels a task, or None, and waits for its end."""
    if task:
        task.cancel()
    await ended(task)
