#include "engine/tracking/ndi/ndi_connection.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

constexpr int kRateAfterReset = 9600;
constexpr Duration kBreakPatience = 1500ms;
constexpr Duration kFirstResetPatience = 300ms;
constexpr Duration kResetCommandPatience = 600ms;
constexpr Duration kRatePatience = 2s;
constexpr Duration kRateChange = 100ms; // that a device takes after COMM

struct Rate {
    int bitsPerSecond;
    char digit; ///< of COMM
};
// COMM also has 14400 and 1228739, which usual adapters do not hold.
constexpr std::array kRates{Rate{9600, '0'},  Rate{19200, '2'},  Rate{38400, '3'},
                            Rate{57600, '4'}, Rate{115200, '5'}, Rate{230400, 'A'},
                            Rate{921600, '6'}};

char rateDigit(int bitsPerSecond)
{
    const auto* rate = std::ranges::find(kRates, bitsPerSecond, &Rate::bitsPerSecond);
    CARINA_EXPECTS(rate != kRates.end());
    return rate->digit;
}

} // namespace

NdiConnection::NdiConnection(std::vector<int> rates, NdiDialogue& dialogue)
    : m_rates{std::move(rates)}, m_dialogue{dialogue}
{
    CARINA_EXPECTS(!m_rates.empty());
}

void NdiConnection::connect(std::function<void()> then)
{
    m_then = std::move(then);
    m_dialogue.queueFirst(resetSteps());
}

std::vector<NdiStep> NdiConnection::resetSteps()
{
    // The device is at the rate after a reset now, whichever it was at.
    const auto onReset = [this](const NdiReply&) {
        m_dialogue.dropSteps();
        m_dialogue.queue({.patience = Duration{0}, .rate = kRateAfterReset});
        for (NdiStep& step : rateSteps())
            m_dialogue.queue(std::move(step));
        m_then();
    };
    const auto goOn = [] {};
    std::vector<NdiStep> steps;
    // A device that was just switched on is at this rate, and many adapters pass no break.
    steps.push_back({.command = {"RESET"},
                     .patience = kFirstResetPatience,
                     .then = onReset,
                     .inVain = goOn,
                     .isReset = true,
                     .rate = kRateAfterReset});
    steps.push_back({.patience = kBreakPatience,
                     .then = onReset,
                     .inVain = goOn,
                     .isReset = true,
                     .sendsBreak = true,
                     .rate = kRateAfterReset});
    std::vector<int> rates{kRateAfterReset};
    std::ranges::copy_if(m_rates, std::back_inserter(rates),
                         [](int rate) { return rate != kRateAfterReset; });
    for (const int rate : rates)
        steps.push_back({.command = {"RESET"},
                         .patience = kResetCommandPatience,
                         .then = onReset,
                         .inVain = goOn,
                         .isReset = true,
                         .rate = rate});
    steps.back().inVain = {};
    return steps;
}

/// None where the rate that is tried is the one after a reset.
std::vector<NdiStep> NdiConnection::rateSteps()
{
    const int wanted = m_rates[m_tried];
    if (wanted == kRateAfterReset)
        return {};
    // Eight bits, no parity, one stop bit, no handshake.
    NdiStep ask{.command = {"COMM", std::string{rateDigit(wanted)} + "0000"},
                .patience = kRatePatience};
    ask.then = [this, wanted](const NdiReply& reply) {
        if (isFine(reply))
            return m_dialogue.queueFirst(
                {{.patience = kRateChange}, {.patience = Duration{0}, .rate = wanted}});
        dropRate(wanted);
        m_dialogue.queueFirst(rateSteps());
    };
    std::vector<NdiStep> steps;
    steps.push_back(std::move(ask));
    return steps;
}

/// The device does not have it.
void NdiConnection::dropRate(int rate)
{
    std::erase(m_rates, rate);
    if (m_rates.empty())
        m_rates.push_back(kRateAfterReset);
    m_tried %= m_rates.size();
}

} // namespace carina
