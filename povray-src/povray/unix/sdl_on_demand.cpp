// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sdl_on_demand.cpp
/// Loads SDL at the preview window's first call, because it loads about thirty other libraries.

#include <string>

#include <dlfcn.h>

#include <SDL.h>

namespace
{

std::string trouble;

void* Library()
{
    static void* const library = []
    {
        void* const loaded = dlopen("libSDL-1.2.so.0", RTLD_NOW);
        if (loaded == nullptr)
            trouble = dlerror();
        return loaded;
    }();
    return library;
}

template<class Function>
Function* Find(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(Library(), name));
}

} // namespace

// without a library SDL_Init fails, then only SDL_GetError is called
#define TILT_LENS_FORWARD(Result, Name, Parameters, arguments)       \
    extern "C" Result Name Parameters                                \
    {                                                                \
        static const auto function = Find<Result Parameters>(#Name); \
        return function arguments;                                   \
    }

extern "C" int SDL_Init(Uint32 flags)
{
    return Library() == nullptr ? -1 : Find<int(Uint32)>("SDL_Init")(flags);
}

extern "C" char* SDL_GetError()
{
    return Library() == nullptr ? trouble.data() : Find<char*()>("SDL_GetError")();
}

TILT_LENS_FORWARD(SDL_Rect**, SDL_ListModes, (SDL_PixelFormat * format, Uint32 flags), (format, flags))
TILT_LENS_FORWARD(SDL_Surface*, SDL_SetVideoMode, (int width, int height, int depth, Uint32 flags), (width, height, depth, flags))
TILT_LENS_FORWARD(SDL_Surface*, SDL_CreateRGBSurface,
                  (Uint32 flags, int width, int height, int depth, Uint32 red, Uint32 green, Uint32 blue, Uint32 alpha),
                  (flags, width, height, depth, red, green, blue, alpha))
TILT_LENS_FORWARD(SDL_Surface*, SDL_DisplayFormat, (SDL_Surface * surface), (surface))
TILT_LENS_FORWARD(void, SDL_FreeSurface, (SDL_Surface * surface), (surface))
TILT_LENS_FORWARD(int, SDL_LockSurface, (SDL_Surface * surface), (surface))
TILT_LENS_FORWARD(void, SDL_UnlockSurface, (SDL_Surface * surface), (surface))
TILT_LENS_FORWARD(int, SDL_FillRect, (SDL_Surface * surface, SDL_Rect* area, Uint32 colour), (surface, area, colour))
TILT_LENS_FORWARD(int, SDL_UpperBlit, (SDL_Surface * from, SDL_Rect* fromArea, SDL_Surface* to, SDL_Rect* toArea),
                  (from, fromArea, to, toArea))
TILT_LENS_FORWARD(void, SDL_UpdateRect, (SDL_Surface * screen, Sint32 x, Sint32 y, Uint32 width, Uint32 height),
                  (screen, x, y, width, height))
TILT_LENS_FORWARD(Uint32, SDL_MapRGBA,
                  (const SDL_PixelFormat* const format, const Uint8 red, const Uint8 green, const Uint8 blue, const Uint8 alpha),
                  (format, red, green, blue, alpha))
TILT_LENS_FORWARD(void, SDL_GetRGBA,
                  (Uint32 pixel, const SDL_PixelFormat* const format, Uint8* red, Uint8* green, Uint8* blue, Uint8* alpha),
                  (pixel, format, red, green, blue, alpha))
TILT_LENS_FORWARD(int, SDL_PollEvent, (SDL_Event * event), (event))
