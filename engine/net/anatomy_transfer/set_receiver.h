#pragma once

#include "engine/net/anatomy_transfer/set_fetch.h"
#include "engine/net/anatomy_transfer/transfer_frame.h"

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
    void take(const transfer::Frame& frame);
    void take(const transfer::Offer& offer);
    void take(const transfer::Refusal& refusal);
    void take(const transfer::Chunk& chunk);
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
