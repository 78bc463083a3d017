#pragma once

#include "models/vitals/vitals_model.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QSlider;

namespace carina
{

/// Whether each kind of sound is played, and how loud.
class SoundControls : public QWidget
{
    Q_OBJECT

public:
    explicit SoundControls(QWidget* parent = nullptr);

    /// @pre the model outlives this
    void setModel(VitalsModel& model);

private:
    struct Controls {
        QCheckBox* isPlayed = nullptr;
        QSlider* volume = nullptr;
    };

    void addKind(SoundKind kind);
    void set(SoundKind kind);
    void refresh();

    VitalsModel* m_model = nullptr;
    std::array<Controls, kSoundKinds.size()> m_controls;
};

} // namespace carina
