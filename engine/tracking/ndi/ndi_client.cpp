#include "engine/tracking/ndi/ndi_client.h"

#include "engine/tracking/ndi/ndi_error.h"
#include "engine/tracking/ndi/ndi_hexadecimal.h"

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

using namespace std::chrono_literals;

constexpr Duration kSetUpPatience = 2s;
constexpr Duration kInitPatience = 5s;    // INIT tests the hardware
constexpr Duration kPosePatience = 250ms; // besides the time of the reply on the line
// No reply has more bytes: TX has 92 for a tool, BX2 has 60 besides.
constexpr std::size_t kReplyBytes = 128;
constexpr std::size_t kReplyBytesOfATool = 96;
constexpr Duration kBeforeRetry = 500ms;
constexpr int kAsksBeforeRetry = 3; // of one that tracked
constexpr Duration kBetweenAsks = 150ms;
// Well below the 16.7 ms between two exposures, by which one is known so much later at most.
constexpr Duration kBeforeNewer = 4ms;
constexpr int kMissedPosesBeforeTold = 2;
constexpr int kMissedPosesBeforeRestart = 4;
constexpr Duration kBetweenLooks = 1s; // at the ports
constexpr Duration kUnreadable = 1s;   // replies, until that is told
constexpr std::uint16_t kPoseOptions = kNdiPoses | kNdiOutOfVolumeToo;
constexpr std::uint8_t kUnknownCommand = 0x01; // ERROR01

/// "Polaris Control Firmware, NDI S/N: P4-00148" of a reply to VER, which has more lines.
std::string deviceNameIn(const NdiReply& reply)
{
    if (errorCode(reply))
        return {};
    std::string name = reply.bytes.substr(0, reply.bytes.find('\n'));
    if (const std::size_t serial = reply.bytes.find("NDI S/N:"); serial != std::string::npos)
        name += ", " + reply.bytes.substr(serial, reply.bytes.find('\n', serial) - serial);
    return name;
}

bool isOff(const NdiTool& tool)
{
    return tool.sight == NdiSight::Disabled || tool.sight == NdiSight::Unoccupied;
}

NdiCommand poseCommand(NdiPoseReply poses, std::uint16_t options)
{
    if (poses == NdiPoseReply::Bx2)
        return {"BX2", "--6d=tools"};
    return {poses == NdiPoseReply::Tx ? "TX" : "BX", ndi::inHexadecimal(options, 4)};
}

} // namespace

NdiClient::NdiClient(NdiClientSettings settings)
    : m_wantedPoses{settings.poses},
      m_poses{settings.poses},
      m_isSerial{settings.isSerial},
      m_dialogue{{.wasReset =
                      [this] {
                          m_mayTrack = false; // it was switched off and on
                          if (m_isSerial && m_phase != Phase::Silent)
                              begin();
                      },
                  .isSilent = [this] { fallSilent(noAnswer()); }}},
      m_connection{std::move(settings.rates), m_dialogue},
      m_tools{std::move(settings.tools), m_dialogue}
{
}

void NdiClient::start(LocalTime now, HoldsRate holdsRate)
{
    m_now = now;
    m_hasLeft = false;
    m_mayTrack = false;
    m_silence.clear();
    m_connection.startOver(std::move(holdsRate));
    begin();
}

/// From whatever state, but at the rate that is tried now.
void NdiClient::begin()
{
    m_dialogue.clear(m_now);
    m_deviceClock = {};
    m_lastFrame.reset();
    m_asksReasons = false;
    m_unreadable.clear();
    m_damagedBefore = m_dialogue.damagedReplies();
    m_phase = Phase::Connecting;
    if (m_isSerial)
        return m_connection.connect([this] { setUp(); },
                                    m_mayTrack ? std::optional{askingWhetherItTracks()}
                                               : std::nullopt);
    // Another program may have left it so; what it answers does not matter.
    m_dialogue.queue({.command = {"TSTOP"}, .patience = kSetUpPatience});
    m_tools.freeAll();
    setUp();
}

void NdiClient::setUp()
{
    m_mayTrack = false;
    m_poses = m_wantedPoses; // it may be another device
    initialise();
    m_dialogue.queue({.command = {"VER", "4"},
                      .patience = kSetUpPatience,
                      .then = [this](const NdiReply& reply) { m_name = deviceNameIn(reply); }});
    m_tools.setUp();
    startTracking();
}

void NdiClient::initialise()
{
    NdiStep init{.command = {"INIT"}, .patience = kInitPatience};
    init.then = [this](const NdiReply& reply) {
        if (!isFine(reply))
            return giveUp("it does not initialise: " + whyRefused(reply));
        m_silence.clear();
        m_connection.keepRate();
        m_phase = Phase::SettingUp;
    };
    init.inVain = [this] {
        m_connection.giveUpRate();
        fallSilent(noAnswer());
    };
    m_dialogue.queue(std::move(init));
}

void NdiClient::startTracking()
{
    NdiStep start{.command = {"TSTART"}, .patience = kSetUpPatience};
    start.then = [this](const NdiReply& reply) {
        if (!isFine(reply))
            return giveUp("it does not track: " + whyRefused(reply));
        m_phase = Phase::Tracking;
        m_nextLook = m_now + kBetweenLooks;
        m_read = m_now;
        listen();
        askForPoses();
    };
    m_dialogue.queue(std::move(start));
}

void NdiClient::askForPoses()
{
    const auto options = std::uint16_t(kPoseOptions | (m_asksReasons ? kNdiMarkerStates : 0));
    NdiStep ask{
        .command = poseCommand(m_poses, options), .patience = posePatience(), .isRepeatable = true};
    ask.then = [this, options](const NdiReply& reply) { takePoses(reply, options); };
    ask.inVain = [this] { missPoses(); };
    m_dialogue.queue(std::move(ask));
}

/// Nothing but this paces a device that answers at once.
void NdiClient::askAgain(bool wasNewer)
{
    if (wasNewer || m_isSerial)
        return askForPoses();
    m_dialogue.queue({.patience = kBeforeNewer, .inVain = [this] { askForPoses(); }});
}

void NdiClient::missPoses()
{
    const Duration silent = m_now - m_heard;
    if (silent >= kMissedPosesBeforeRestart * posePatience())
        return fallSilent(noAnswer());
    if (silent >= kMissedPosesBeforeTold * posePatience())
        m_silence = noAnswer();
    askForPoses();
}

/// At its rate, and in the middle of other attempts.
NdiStep NdiClient::askingWhetherItTracks()
{
    NdiStep ask{.command = poseCommand(m_poses, kPoseOptions),
                .patience = posePatience(),
                .inVain = [] {},
                .isRepeatable = true};
    if (m_isSerial)
        ask.rate = m_connection.rate();
    ask.then = [this](const NdiReply& reply) {
        if (errorCode(reply))
            return; // the other attempts go on
        m_dialogue.dropSteps();
        m_phase = Phase::Tracking;
        m_read = m_now;
        takePoses(reply, kPoseOptions);
    };
    return ask;
}

/// The time that the largest reply takes on the line, and a margin.
Duration NdiClient::posePatience() const
{
    if (!m_isSerial)
        return kPosePatience;
    const std::size_t tools = m_tools.count() + m_tools.pluggedIn();
    return kPosePatience + m_dialogue.wireTime(kReplyBytes + tools * kReplyBytesOfATool);
}

void NdiClient::leave()
{
    m_hasLeft = m_phase == Phase::Connecting || m_phase == Phase::Silent;
    if (m_phase != Phase::Tracking)
        m_dialogue.clear(m_now);
    if (m_hasLeft)
        return;
    const auto done = [this] {
        m_hasLeft = true;
        m_dialogue.dropSteps();
    };
    m_dialogue.queue({.command = {"TSTOP"}, .patience = kSetUpPatience, .inVain = done});
    m_tools.freeAll();
    m_dialogue.queue({.patience = Duration{0}, .inVain = done}); // all was answered
}

void NdiClient::take(std::span<const std::byte> bytes, LocalTime now)
{
    m_now = now;
    m_dialogue.take(bytes, now);
}

NdiPortAction NdiClient::advance(LocalTime now)
{
    m_now = now;
    return m_dialogue.advance(now);
}

void NdiClient::takePoses(const NdiReply& reply, std::uint16_t options)
{
    listen();
    if (const auto code = errorCode(reply)) {
        if (*code != kUnknownCommand || m_poses == NdiPoseReply::Tx)
            return giveUp("it does not track: " + errorMeaning(*code));
        m_poses = m_poses == NdiPoseReply::Bx2 ? NdiPoseReply::Bx : NdiPoseReply::Tx;
        return askForPoses();
    }
    m_asksReasons = false;
    const auto frame = decoded(reply, options);
    if (!frame) {
        ++m_undecoded;
        m_unreadable = frame.error().detail;
        return askAgain(false);
    }
    m_read = m_now;
    m_unreadable.clear();
    askAgain(measure(*frame));
}

Result<NdiFrame> NdiClient::decoded(const NdiReply& reply, std::uint16_t options) const
{
    const auto body = std::as_bytes(std::span{reply.bytes});
    switch (m_poses) {
    case NdiPoseReply::Tx:
        return decodeTx(reply.bytes, options);
    case NdiPoseReply::Bx:
        return decodeBx(body, options);
    case NdiPoseReply::Bx2:
        break;
    }
    return decodeBx2(body);
}

/// By the device's clock where it tells it, else when the reply was sent.
LocalTime NdiClient::exposureOf(const NdiFrame& frame)
{
    const LocalTime sent = m_isSerial ? m_now - m_dialogue.replyTime() : m_now;
    return frame.deviceTime ? m_deviceClock.local(*frame.deviceTime, sent) : sent;
}

/// @returns whether it is a newer exposure than the last, which then is passed on
bool NdiClient::measure(const NdiFrame& frame)
{
    NdiMeasurement measured{exposureOf(frame), {}};
    measured.tools.resize(m_tools.count());
    for (std::size_t tool = 0; tool < m_tools.count(); ++tool)
        if (m_tools.isUnplugged(tool))
            measured.tools[tool] = NdiTool{.sight = NdiSight::Unoccupied};
    std::optional<std::uint32_t> number;
    for (const NdiTool& tool : frame.tools) {
        const auto wanted = m_tools.toolOf(tool.handle);
        if (!wanted)
            continue;
        measured.tools[*wanted] = tool;
        if (isOff(tool))
            continue; // without a number
        number = std::max(number.value_or(0), tool.frameNumber);
        m_asksReasons = m_asksReasons || !tool.X_TO;
    }
    lookAtPorts(frame);
    if (number == m_lastFrame)
        return false;
    m_lastFrame = number;
    m_measured.push_back(std::move(measured));
    return true;
}

/// After a tool was plugged in or out: by TX and BX the system says so, by BX2 a tool that is off,
/// and nothing that it is back.
void NdiClient::lookAtPorts(const NdiFrame& frame)
{
    const bool isAnyOff = std::ranges::any_of(frame.tools, [this](const NdiTool& tool) {
        const auto wanted = m_tools.toolOf(tool.handle);
        return wanted && m_tools.isWired(*wanted) && isOff(tool);
    });
    const bool isTold = (frame.status & (kNdiPortOccupied | kNdiPortUnoccupied)) != 0;
    if (m_now < m_nextLook || !(isTold || isAnyOff || m_tools.isAnyAwaited()))
        return;
    m_nextLook = m_now + kBetweenLooks;
    m_tools.lookAtPorts([this](const NdiReply& restarted) {
        if (!isFine(restarted))
            return giveUp("it does not track: " + whyRefused(restarted));
        m_lastFrame.reset(); // it may count anew
        listen();
    });
}

void NdiClient::listen()
{
    m_heard = m_now;
    m_silence.clear();
    m_mayTrack = true;
    m_damagedBefore = m_dialogue.damagedReplies();
}

std::string NdiClient::noAnswer() const
{
    return m_dialogue.damagedReplies() > m_damagedBefore
               ? "its replies arrive damaged: see that its cable is whole and plugged in firmly"
               : "it does not answer";
}

void NdiClient::fallSilent(std::string why)
{
    m_silence = std::move(why);
    m_phase = Phase::Silent;
    m_dialogue.clear(m_now);
    for (int asks = 0; m_mayTrack && asks < kAsksBeforeRetry; ++asks) {
        m_dialogue.queue(askingWhetherItTracks());
        m_dialogue.queue({.patience = kBetweenAsks});
    }
    m_dialogue.queue(
        {.patience = m_mayTrack ? Duration{0} : kBeforeRetry, .inVain = [this] { begin(); }});
}

/// It refuses, and is brought to tracking from the beginning.
void NdiClient::giveUp(std::string why)
{
    m_mayTrack = false;
    fallSilent(std::move(why));
}

std::vector<NdiMeasurement> NdiClient::takeMeasurements() { return std::exchange(m_measured, {}); }

std::string NdiClient::trouble() const
{
    if (!m_silence.empty())
        return m_silence;
    if (!m_unreadable.empty() && m_now - m_read >= kUnreadable)
        return "its replies cannot be read: " + m_unreadable;
    return m_tools.refusals();
}

std::optional<NdiFound> NdiClient::found() const
{
    if (m_phase != Phase::Tracking || isSilent())
        return std::nullopt;
    return NdiFound{m_name, m_tools.pluggedIn()};
}

} // namespace carina
