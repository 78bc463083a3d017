#include "engine/tracking/ndi/ndi_error.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace carina
{
namespace
{

struct Meaning {
    std::uint8_t code;
    const char* words;
};

// Reserved are 1D, 20, 26, 27, 29, 31, 3A, 3E and 3F; 1D and 20 were errors of older devices.
constexpr std::array kMeanings{
    Meaning{0x01, "a command that the device does not know"},
    Meaning{0x02, "a command that is too long"},
    Meaning{0x03, "a command that is too short"},
    Meaning{0x04, "the command arrived damaged: see that the cable is whole and plugged in firmly"},
    Meaning{0x05, "the command took the device too long"},
    Meaning{0x06, "the new rate of transmission could not be set"},
    Meaning{0x07, "a wrong number of parameters"},
    Meaning{0x08, "a port that the device does not have"},
    Meaning{0x09, "a mode that the device does not have"},
    Meaning{0x0A, "a light that the tool does not have"},
    Meaning{0x0B, "a state that a light does not have"},
    Meaning{0x0C, "the command is not possible in the present mode"},
    Meaning{0x0D, "no tool is plugged into the port"},
    Meaning{0x0E, "the port is not initialised"},
    Meaning{0x0F, "the port is not enabled"},
    Meaning{0x10, "the device is not initialised"},
    Meaning{0x11, "the device could not stop tracking"},
    Meaning{0x12, "the device could not start tracking"},
    Meaning{0x13,
            "the tool could not be initialised: see that it is plugged in firmly, or that its "
            "definition is right"},
    Meaning{0x14, "the parameters of the position sensor are invalid: have the device serviced"},
    Meaning{0x15, "the device could not be initialised: switch it off and on"},
    Meaning{0x16, "diagnosis could not be started"},
    Meaning{0x17, "diagnosis could not be stopped"},
    Meaning{0x18, "other infrared light could not be determined"},
    Meaning{0x19, "the version of the firmware could not be read"},
    Meaning{0x1A, "an internal error of the device: switch it off and on"},
    Meaning{0x1B, "diagnosis of infrared light could not be initialised"},
    Meaning{0x1C, "the firing of the markers could not be set"},
    Meaning{0x1D, "the memories of the tools could not be searched"},
    Meaning{0x1E, "the memory of the tool could not be read: see that it is plugged in firmly"},
    Meaning{0x1F, "the memory of the tool could not be written"},
    Meaning{0x20, "the memory of the tool could not be selected"},
    Meaning{0x21, "the current of the tool could not be tested: see that it is plugged in firmly"},
    Meaning{0x22, "the chosen volume has no parameters for the wavelength of an enabled tool"},
    Meaning{0x23, "a parameter is out of range"},
    Meaning{0x24, "the position sensor has no parameters for this volume"},
    Meaning{0x25, "the features of the device could not be determined"},
    Meaning{0x28, "too many tools, or a kind of tool that the device does not track"},
    Meaning{0x2A, "the memory of the device is full: use fewer tools"},
    Meaning{0x2B, "a port handle that is not allocated"},
    Meaning{0x2C, "the tool was unplugged: plug it in again"},
    Meaning{0x2D, "all port handles are in use: use fewer tools"},
    Meaning{0x2E, "parts of the device have firmware that does not go together: update it"},
    Meaning{0x2F, "the description of a port is invalid"},
    Meaning{0x30, "the port has a handle already"},
    Meaning{0x32, "the part of the device at this port handle cannot do that"},
    Meaning{0x33, "the device does not have this feature"},
    Meaning{0x34, "a user parameter that does not exist"},
    Meaning{0x35, "a value of a wrong type"},
    Meaning{0x36, "the value of a user parameter is out of range"},
    Meaning{0x37, "the index into a user parameter is out of range"},
    Meaning{0x38, "the size of a user parameter is wrong"},
    Meaning{0x39, "not permitted: another program may have the device, close it"},
    Meaning{0x3B, "a file that the device does not have"},
    Meaning{0x3C, "a file of the device could not be written"},
    Meaning{0x3D, "a file of the device could not be read"},
    Meaning{0x40, "the definition of the tool is damaged: take a whole .rom file"},
    Meaning{0x41,
            "the definition of the tool asks for more markers or faces than the device tracks"},
    Meaning{0x42, "a part of the device is not connected: see that its cables are plugged in"},
    Meaning{0xF1, "too much other infrared light: take away lamps, sunlight and reflections"},
    Meaning{0xF4, "the memory of the device could not be erased: have it serviced"},
    Meaning{0xF5, "the memory of the device could not be written: have it serviced"},
    Meaning{0xF6, "the memory of the device could not be read: have it serviced"},
};

} // namespace

std::string errorMeaning(std::uint8_t code)
{
    const auto* const known = std::ranges::find(kMeanings, code, &Meaning::code);
    if (known != kMeanings.end())
        return known->words;
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    return std::string{"error "} + kDigits[code >> 4U] + kDigits[code & 0xFU];
}

} // namespace carina
