#pragma once

#include "engine/net/carriage/carriage_frame.h"
#include "engine/net/carriage/set_fetch.h"

#include <QSslSocket>
#include <QTimer>

namespace carina
{

/// The part of SetFetch on its thread.
class SetReceiver : public QObject
{
public:
    SetReceiver(SetFetch& fetch, HostDoor door, std::string contentHash,
                std::filesystem::path cacheFolder);

    void connectToHost();

private:
    struct DeleteLater {
        void operator()(QSslSocket* socket) const;
    };

    void makeSocket();
    void answerKey(QSslPreSharedKeyAuthenticator& question) const;
    void ask();
    void broken();
    void read();
    void take(const carriage::Frame& frame);
    void take(const carriage::Offer& offer);
    void take(const carriage::Refusal& refusal);
    void take(const carriage::Chunk& chunk);
    void finish();
    void arrived();
    void retry(std::optional<Error> fault);
    void giveUp(Error why);
    void show() { m_fetch.show(m_status); }

    SetFetch& m_fetch;
    HostDoor m_door;
    std::string m_contentHash;
    CarriedSets m_sets;
    FetchStatus m_status;
    std::unique_ptr<QSslSocket, DeleteLater> m_socket;
    QByteArray m_received; // less than one frame
    std::unique_ptr<PartialSet> m_partial;
    bool m_resumed = false; // m_partial was begun by an earlier try
    int m_rejections = 0;
    Duration m_pause = SetFetch::kFirstPause;
    QTimer m_patience{this};
    QTimer m_again{this};
};

} // namespace carina
