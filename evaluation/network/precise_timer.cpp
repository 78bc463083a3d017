#include "evaluation/network/precise_timer.h"

#include "engine/core/expects.h"

#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>

namespace carina
{

PreciseTimer::PreciseTimer(std::function<void()> onTime)
    : m_onTime{std::move(onTime)},
      m_file{timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)}
{
    CARINA_EXPECTS(m_file >= 0);
    m_notifier.emplace(m_file, QSocketNotifier::Read);
    QObject::connect(&*m_notifier, &QSocketNotifier::activated, &*m_notifier, [this] {
        std::uint64_t times = 0;
        if (::read(m_file, &times, sizeof times) == sizeof times)
            m_onTime();
    });
}

PreciseTimer::~PreciseTimer()
{
    m_notifier.reset();
    ::close(m_file);
}

void PreciseTimer::setTo(LocalTime machine)
{
    // All zero would stop it.
    const auto whole = std::max<Duration::rep>(machine.time_since_epoch().count(), 1);
    const itimerspec when{{}, {whole / 1'000'000'000, whole % 1'000'000'000}};
    const int set = ::timerfd_settime(m_file, TFD_TIMER_ABSTIME, &when, nullptr);
    CARINA_EXPECTS(set == 0);
}

} // namespace carina
