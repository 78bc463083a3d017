#include "engine/session/participant_limits.h"

namespace carina
{

PeerLimits limitsOf(Role role)
{
    switch (role) {
    case Role::Instructor:
        return {.datagrams = 2000.0,
                .bytes = 1e6,
                .comings = 2.0,
                .proposals = 100.0,
                .events = 400.0,
                .samples = 4000.0,
                .messages = 4000.0};
    case Role::Trainee:
        return {.datagrams = 2000.0,
                .bytes = 5e5,
                .comings = 2.0,
                .proposals = 20.0,
                .events = 400.0,
                .samples = 1000.0,
                .messages = 1000.0};
    case Role::Observer:
        return {.datagrams = 2000.0,
                .bytes = 2e5,
                .comings = 1.0,
                .proposals = 2.0,
                .events = 0.0,
                .samples = 0.0,
                .messages = 1000.0};
    }
    return {};
}

SharedLimits sharedLimitsOf(Role role)
{
    switch (role) {
    case Role::Instructor:
        return {.datagrams = 16000.0, .bytes = 8e6, .proposals = 200.0, .events = 1600.0};
    case Role::Trainee:
        return {.datagrams = 16000.0, .bytes = 4e6, .proposals = 40.0, .events = 1600.0};
    case Role::Observer:
        return {.datagrams = 8000.0, .bytes = 8e5, .proposals = 4.0, .events = 0.0};
    }
    return {};
}

std::size_t mostObjectsOf(Role role)
{
    switch (role) {
    case Role::Instructor:
        return 64;
    case Role::Trainee:
        return 8;
    case Role::Observer:
        return 0;
    }
    return 0;
}

std::size_t mostPresentOf(Role role)
{
    switch (role) {
    case Role::Instructor:
        return 32;
    case Role::Trainee:
        return 224;
    case Role::Observer:
        return 64;
    }
    return 0;
}

std::size_t mostNamesOf(Role role)
{
    switch (role) {
    case Role::Instructor:
        return 128;
    case Role::Trainee:
        return 768;
    case Role::Observer:
        return 128;
    }
    return 0;
}

std::size_t mostNamesFrom(Role role)
{
    switch (role) {
    case Role::Instructor:
        return 96;
    case Role::Trainee:
        return 512;
    case Role::Observer:
        return 96;
    }
    return 0;
}

std::size_t mostPresentFrom(Role role)
{
    switch (role) {
    case Role::Instructor:
        return 28;
    case Role::Trainee:
        return 216;
    case Role::Observer:
        return 60;
    }
    return 0;
}

} // namespace carina
