# povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Tasks that nobody waits for."""

import asyncio
import traceback


def print_fault(task):
    if not task.cancelled() and task.exception():
        traceback.print_exception(task.exception())


def started(coroutine):
    """Prints the exception that ends the task."""
    task = asyncio.create_task(coroutine)
    task.add_done_callback(print_fault)
    return task


async def ended(task):
    """Ignores the outcome."""
    if task:
        await asyncio.wait([task])


async def stopped(task):
    if task:
        task.cancel()
    await ended(task)
