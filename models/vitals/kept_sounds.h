#pragma once

#include "engine/audio/sound_mixer.h"

#include <QString>

#include <array>

namespace carina
{

/// How loud a program plays each kind of sound, which it does not, and whether it plays none at
/// all, remembered from one start to the next in a file of a folder. What cannot be read there is
/// as if it were not there. A program that has no file of its own yet begins with the one that all
/// programs of the folder shared before (sounds.ini).
class KeptSounds
{
public:
    struct Loudness {
        int volume_percent = 70;
        bool isMuted = false;

        friend bool operator==(const Loudness&, const Loudness&) = default;
    };

    /// Remembers nothing.
    KeptSounds() = default;
    /// @param folder an empty one: nothing is remembered
    /// @param program its name in the name of the file: programs of one folder are muted each by
    ///        itself
    KeptSounds(const QString& folder, const QString& program);

    [[nodiscard]] Loudness of(SoundKind kind) const;
    /// @pre the volume is from 0 to 100
    void keep(SoundKind kind, const Loudness& loudness);

    /// Whether none is played, whatever holds of each kind.
    [[nodiscard]] bool isMuted() const { return m_isMuted; }
    void keepMuted(bool isMuted);

private:
    void read(const QString& file);

    QString m_file;
    std::array<Loudness, kSoundKinds.size()> m_sounds;
    bool m_isMuted = false;
};

} // namespace carina
