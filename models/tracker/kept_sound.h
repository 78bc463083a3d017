#pragma once

#include <QString>

namespace carina
{

/// Whether a program makes a sound when a tool is lost: it does until a person silences it, which
/// is remembered from one start to the next, in a file of a folder. What cannot be read there is as
/// if it were not there.
class KeptSound
{
public:
    /// Remembers nothing.
    KeptSound() = default;
    /// @param folder an empty one: nothing is remembered
    explicit KeptSound(const QString& folder);

    [[nodiscard]] bool isOn() const { return m_isOn; }
    void keep(bool isOn);

private:
    QString m_file;
    bool m_isOn = true;
};

} // namespace carina
