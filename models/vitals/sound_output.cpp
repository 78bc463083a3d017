#include "models/vitals/sound_output.h"

#include "models/vitals/sound_format.h"

#include <QAudioDevice>
#include <QAudioSink>
#include <QIODevice>

#include <utility>
#include <vector>

namespace carina
{
namespace
{

constexpr int kFeedInterval_ms = 20;
/// What is computed ahead: as long as the drawing of a picture may keep the program busy.
constexpr qint64 kSoundAhead_us = 150'000;

} // namespace

SoundOutput::SoundOutput(Render render, QObject* parent)
    : QObject{parent}, m_render{std::move(render)}
{
    connect(&m_devices, &QMediaDevices::audioOutputsChanged, this, &SoundOutput::open);
    connect(&m_feeding, &QTimer::timeout, this, &SoundOutput::feed);
    m_feeding.setTimerType(Qt::PreciseTimer);
    m_feeding.setInterval(kFeedInterval_ms);
    open();
}

SoundOutput::~SoundOutput() = default;

void SoundOutput::open()
{
    close();
    say(tryToOpen());
}

void SoundOutput::close()
{
    m_feeding.stop();
    m_input = nullptr;
    m_sink.reset();
}

void SoundOutput::say(const QString& obstacle)
{
    if (std::exchange(m_obstacle, obstacle) != obstacle)
        Q_EMIT changed();
}

/// @returns what prevents it
QString SoundOutput::tryToOpen()
{
    const QAudioDevice device = QMediaDevices::defaultAudioOutput();
    if (device.isNull())
        return tr("No sound: this computer has no audio device. Connect loudspeakers or "
                  "headphones; all sounds are shown on the screen, too.");
    const auto format = playableFormat(device);
    if (!format)
        return tr("No sound: the audio device “%1” plays no sound of 48\u00a0kHz. Choose another "
                  "one in the settings of this computer.")
            .arg(device.description());
    m_format = *format;
    m_sink = std::make_unique<QAudioSink>(device, m_format);
    m_sink->setBufferSize(m_format.bytesForDuration(kSoundAhead_us));
    m_input = m_sink->start();
    if (!m_input || m_sink->error() != QAudio::NoError) {
        close();
        return tr("No sound: the audio device “%1” does not start. Choose another one in the "
                  "settings of this computer.")
            .arg(device.description());
    }
    // Queued: the sink must not be destroyed within its own signal.
    connect(m_sink.get(), &QAudioSink::stateChanged, this, &SoundOutput::follow,
            Qt::QueuedConnection);
    m_feeding.start();
    return {};
}

/// A device may fail while it plays; it is tried again once the devices change.
void SoundOutput::follow()
{
    if (!m_sink || m_sink->state() != QAudio::StoppedState)
        return;
    close();
    say(tr("No sound: the audio device has stopped. Connect it again, or choose another one in the "
           "settings of this computer."));
}

void SoundOutput::feed()
{
    const qsizetype frames = m_sink->bytesFree() / m_format.bytesPerFrame();
    if (frames <= 0)
        return;
    std::vector<float> samples(static_cast<std::size_t>(frames));
    m_render(samples);
    m_input->write(soundBytes(samples, m_format));
}

} // namespace carina
